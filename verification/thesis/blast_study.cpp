#include "verification/thesis/blast_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <utility>

#include "verification/exact/pressurised_cavity.h"
#include "verification/harness/recorded_run.h"
#include "verification/study/job_progress.h"

namespace verify {
namespace {

struct Variant {
  std::string name;
  std::string description;
  dda::JointMaterial joint;
  dda::Integrator integrator;
  bool element = false;
};

// Springs of 10 E per vertex, shear 0.4 of it, as in chapters 3 and 6.
dda::JointMaterial classical_joint() {
  dda::JointMaterial joint;
  joint.law = dda::InterfaceLaw::classical;
  joint.spring_over_young = 10;
  joint.shear_to_normal = 0.4;
  return joint;
}

std::vector<Variant> variants(const ThesisBlast& blast) {
  dda::JointMaterial dry = classical_joint();
  dry.friction_angle = blast.friction_angle;
  dda::JointMaterial glued = classical_joint();
  glued.bonded = true;
  dda::JointMaterial rock;
  rock.law = dda::InterfaceLaw::consistent;
  rock.bonded = true;
  return {
      {"dry", "joints with a friction angle of 45 deg and no cohesion, corner springs, Eq. 5: the thesis' text", dry,
       dda::thesis_integrator()},
      {"element",
       fmt::format("the same, with the text's element of eight blocks in the hole: edges of {:g} m outside and {:g} "
                   "m inside, where they bear the same force",
                   blast.octagon_edge, element_hollow * blast.octagon_edge),
       dry, dda::thesis_integrator(), true},
      {"glued", "the springs of `dry`, joints that neither open nor slide", glued, dda::thesis_integrator()},
      {"continuous", "consistent joints, trapezoidal rule: this engine's accurate scheme for solid rock", rock,
       dda::trapezoidal_integrator()}};
}

BlastReading reading_of(const std::vector<double>& velocity, const std::vector<double>& stress, double dt) {
  const auto fastest = std::max_element(velocity.begin(), velocity.end());
  return {dt * static_cast<double>(fastest - velocity.begin()), *fastest,
          -*std::min_element(stress.begin(), stress.end())};
}

std::vector<double> difference(const std::vector<double>& with, const std::vector<double>& without) {
  std::vector<double> result(with.size());
  std::transform(with.begin(), with.end(), without.begin(), result.begin(), std::minus<>());
  return result;
}

RecordedRun counted_run(const ThesisBlast& blast, const BlastRun& run, JobProgress& progress) {
  RecordedRun recorded = record_run(blast_scene(blast, run));
  progress.job_ended();
  return recorded;
}

struct BlastedAndNot {
  RecordedRun with, without;
};

BlastedAndNot run_both(const ThesisBlast& blast, const Variant& variant, const BlastMesh& mesh, double duration,
                       JobProgress& progress) {
  BlastRun run{variant.joint, variant.integrator, blast.time_step, duration, equation_18(blast), true,
               mesh,          variant.element};
  RecordedRun with = counted_run(blast, run, progress);
  run.loaded = false;
  return {std::move(with), counted_run(blast, run, progress)};
}

BlastResult run_variant(const ThesisBlast& blast, const Variant& variant, const BlastOptions& options,
                        JobProgress& progress) {
  const auto [with, without] = run_both(blast, variant, options.mesh, options.duration, progress);
  BlastResult result{variant.name, variant.description, {}, 0, with.cpu_s};
  for (std::size_t i = 0; i + 1 < with.histories.size(); i += 2) {
    for (const double velocity : without.histories[i])
      result.largest_without = std::max(result.largest_without, std::abs(velocity));
    result.readings.push_back(reading_of(difference(with.histories[i], without.histories[i]),
                                         difference(with.histories[i + 1], without.histories[i + 1]), blast.time_step));
  }
  return result;
}

// To 23 m each way, until the peaks have passed H1 and V1.
DecayResult run_decay(const ThesisBlast& blast, double decay_time, JobProgress& progress) {
  const Variant dry = variants(blast).front();
  const BlastRun run{dry.joint, dry.integrator, blast.time_step, 3.5e-3, {decay_time, 0}, true, {2, 2}, false};
  const RecordedRun recorded = counted_run(blast, run, progress);
  const std::vector<PrintedArrival> points = points_inside(blast, run.mesh);
  const auto reading = [&](const std::string& name) {
    const auto at = std::find_if(points.begin(), points.end(), [&](const auto& p) { return p.point == name; });
    const auto i = 2 * static_cast<std::size_t>(at - points.begin());
    return reading_of(recorded.histories.at(i), recorded.histories.at(i + 1), run.dt);
  };
  return {decay_time, reading("H1"), reading("V1")};
}

// Velocities at the points inside this mesh, with the blast minus without.
std::vector<std::vector<double>> velocities(const ThesisBlast& blast, const Variant& variant, const BlastMesh& mesh,
                                            double duration, JobProgress& progress) {
  const auto [with, without] = run_both(blast, variant, mesh, duration, progress);
  std::vector<std::vector<double>> all;
  for (std::size_t i = 0; i < with.histories.size(); i += 2)
    all.push_back(difference(with.histories[i], without.histories[i]));
  return all;
}

// Edges 23 m from the blast, from which waves are back at the points after 5 to 8 ms, against edges 39 m away: 12 ms.
EdgeResult run_edges(const ThesisBlast& blast, const Variant& variant, double duration, JobProgress& progress) {
  constexpr BlastMesh near_mesh{2, 2}, far_mesh{4, 4};
  const std::vector<PrintedArrival> points = points_inside(blast, near_mesh);
  const std::vector<PrintedArrival> more_points = points_inside(blast, far_mesh);
  const auto near = velocities(blast, variant, near_mesh, duration, progress);
  const auto far = velocities(blast, variant, far_mesh, duration, progress);
  EdgeResult result{variant.name, "", 0};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto same = std::ranges::find(more_points, points[i].point, &PrintedArrival::point);
    const std::vector<double>& undisturbed = far.at(static_cast<std::size_t>(same - more_points.begin()));
    const double peak = std::ranges::max(undisturbed);
    double most = 0;
    for (const double each : difference(near[i], undisturbed)) most = std::max(most, std::abs(each));
    if (most <= result.difference * peak) continue;
    result.difference = most / peak;
    result.point = points[i].point;
  }
  return result;
}

// The circular cavity that sends out the octagon's long waves, in endless rock without joints.
BlastResult axisymmetric(const ThesisBlast& blast, const BlastStudy& study) {
  const double equal_area = blast.octagon_edge * std::sqrt(2 * (1 + std::numbers::sqrt2) / std::numbers::pi);
  const double p = blast.speed_plane_stress();
  const double shear = blast.young / (2 * (1 + blast.poisson));
  const exact::Cavity cavity{exact::octagon_source_radius(equal_area), blast.density * p * p, shear, blast.density};
  const BlastPulse pulse = equation_18(blast);
  std::vector<double> radii;
  for (const PrintedArrival& point : study.points) radii.push_back(point.distance);
  const exact::CavityMotion motion = exact::pressurised_cavity(
      cavity, [&](double t) { return blast.peak_pressure * blast_factor(pulse, t); }, radii, study.duration, 100);
  BlastResult result{"axisymmetric", "wave equation in the radius, no joints", {}, 0, 0};
  for (const exact::RadialHistory& history : motion.histories)
    result.readings.push_back(reading_of(history.velocity, history.radial_stress, motion.interval));
  return result;
}

// With the blast and without it; before edges on two meshes.
std::size_t runs_of(const BlastOptions& options, std::size_t variants) {
  const std::size_t of_edges = options.duration_of_edges > 0 ? 4 * variants : 0;
  return 2 * variants + options.decay_times.size() + of_edges;
}

}  // namespace

BlastStudy run_blast_study(const ThesisBlast& blast, const BlastOptions& options) {
  BlastStudy study;
  study.points = points_inside(blast, options.mesh);
  study.dt = blast.time_step;
  study.duration = options.duration;
  const BlastRun any{
      classical_joint(), dda::thesis_integrator(), study.dt, study.duration, {}, false, options.mesh, false};
  study.blocks = static_cast<int>(blast_scene(blast, any).blocks.size());
  JobProgress progress(runs_of(options, variants(blast).size()), options.progress);
  for (const Variant& variant : variants(blast))
    study.results.push_back(run_variant(blast, variant, options, progress));
  study.results.push_back(axisymmetric(blast, study));
  for (const double decay_time : options.decay_times) study.decays.push_back(run_decay(blast, decay_time, progress));
  if (options.duration_of_edges > 0)
    for (const Variant& variant : variants(blast))
      study.edges.push_back(run_edges(blast, variant, options.duration_of_edges, progress));
  return study;
}

}  // namespace verify
