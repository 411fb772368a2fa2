// Scenes as text, with the record in a file beside them: what a user does.
#include "verification/cases/base_shaking_cases.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/core/temporary_folder.h"
#include "engine/scene/scene.h"
#include "engine/simulation/simulation.h"
#include "verification/exact/base_motion.h"
#include "verification/harness/histories.h"
#include "verification/harness/recorded_run.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

constexpr double gravity_unit = 9.80665;  // m/s2 in 1 g
constexpr double sampling = 0.005;        // s
constexpr int samples = 241;

// A made-up quake of 1.2 s, in g: three swings of different lengths under one hump.
double ground_acceleration(double t) {
  return 0.3 * std::sin(2.6 * t) * (std::sin(31 * t) + 0.6 * std::sin(83 * t + 1) - 0.4 * std::cos(173 * t));
}

exact::Accelerogram accelerogram() {
  exact::Accelerogram record;
  for (int i = 0; i < samples; ++i) {
    record.times.push_back(sampling * i);
    record.values.push_back(gravity_unit * ground_acceleration(sampling * i));
  }
  return record;
}

// A folder of its own with the record in it, gone at the end.
class RecordFolder {
 public:
  RecordFolder() {
    std::ofstream stream(path() / "quake.csv");
    stream << "# made up\nt [s],ay [g],ax [g]\n";
    for (int i = 0; i < samples; ++i)
      stream << fmt::format("{},{},{}\n", sampling * i, 0.0, ground_acceleration(sampling * i));
    if (!stream) throw std::runtime_error("the record cannot be written to " + path().string());
  }
  [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }

 private:
  dda::TemporaryFolder folder_;
};

constexpr double young = 2e9;
constexpr double density = 2000;
constexpr double length = 2;
constexpr double height = 1;
constexpr double spring = 4e7;  // N/m, at each end of the joint
constexpr double end_time = 1.35;

// A base with a block glued to its right side, shaken along x.
dda::Model shaken_block(const std::string& joint, const std::string& integrator, const std::string& kinematics,
                        int steps, const RecordFolder& folder) {
  const std::string scene = fmt::format(
      R"({{"dda": 1, "materials": {{"rock": {{"density": {}, "young": {}, "poisson": 0}}}},
           "joints": {{"default": {{"bonded": true, {}}}}},
           "blocks": [{{"polygon": {{"name": "base", "vertices": [[-1, 0], [0, 0], [0, {}], [-1, {}]]}}}},
                      {{"bar": {{"name": "glued", "length": {}, "height": {}, "block_length": {}}}}}],
           "supports": [{{"block": "base", "acceleration": [1, 0],
                          "history": {{"record": {{"file": "quake.csv", "value": "ax"}}}}}}],
           "steps": {{"dt": {}, "duration": {}, "integrator": {}, "kinematics": "{}", "solver": "cholesky"}}}})",
      density, young, joint, height, height, length, height, length, end_time / steps, end_time, integrator,
      kinematics);
  return dda::parse_scene(scene, "shaken block", folder.path());
}

// The base itself: position and velocity are the integrals of what stands in the file. The glued block lags behind by
// its elastic answer to its own inertia, at most the peak acceleration over the square of its lowest frequency, twice
// (a load that is suddenly there).
Outcome glued_block() {
  const RecordFolder folder;
  const exact::Accelerogram record = accelerogram();
  Outcome outcome;
  for (const std::string kinematics : {"small", "finite"}) {
    constexpr int steps = 1350;
    const std::string joint = R"("law": "consistent")";
    dda::Simulation simulation(shaken_block(joint, R"({"generalized_alpha": 0.8})", kinematics, steps, folder));
    double position = 0, largest = 0, speed = 0, lag = 0;
    while (!simulation.finished()) {
      advance(simulation, 1);
      const exact::BaseMotion exact = exact::base_motion(record, simulation.state().time);
      keep_largest(position, simulation.state().displacement[0](0) - exact.displacement);
      keep_largest(speed, simulation.state().velocity[0](0) - exact.velocity);
      keep_largest(lag, simulation.state().displacement[1](0) - exact.displacement);
      keep_largest(largest, exact.displacement);
    }
    outcome.counters += simulation.counters();
    const std::string source = "the record integrated twice, cubic between samples (verification/exact/base_motion.h)";
    outcome.assertions.push_back(
        expect("largest distance of the base from the record, " + kinematics + " kinematics", "m")
            .is(position)
            .against(0, source)
            .off_by(position / largest)
            .within(1e-13,
                    "of the largest displacement: round-off of 240 intervals and of the numbers in the "
                    "file"));
    outcome.assertions.push_back(
        expect("largest difference of the base's velocity, " + kinematics + " kinematics", "m/s")
            .is(speed)
            .against(0, source + " (error absolute)")
            .absolutely()
            .within(1e-13, "the same"));
    // Lowest frequency: a fixed-free block of P1 strain glued along its side: E A/L of the block over a third of its
    // mass; the joint of the consistent law adds none.
    const double lowest = 3 * young / (density * length * length);
    double peak = 0;
    for (const double value : record.values) keep_largest(peak, value);
    outcome.assertions.push_back(
        expect("largest lag of the glued block, " + kinematics + " kinematics", "m")
            .is(lag)
            .against(0, "elastic answer to its own inertia (error absolute)")
            .absolutely()
            .within(2 * peak / lowest, "twice the static answer to the peak acceleration, a rho L^2/(3 E)"));
  }
  return outcome;
}

// The block on its springs: u of its centroid and its strain e, both against the base.
struct Modes {
  Eigen::Matrix2d shapes;  // columns, M-orthonormal
  Eigen::Vector2d omega;
  Eigen::Vector2d participation;  // of a rigid displacement
};

Modes modes() {
  const double mass = density * length * height;
  const Eigen::Matrix2d m = Eigen::Vector2d(mass, mass * length * length / 12).asDiagonal();
  const Eigen::Vector2d gap(1, -length / 2);
  Eigen::Matrix2d k = 2 * spring * gap * gap.transpose();
  k(1, 1) += young * length * height;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> solver(k, m);
  return {solver.eigenvectors(), solver.eigenvalues().cwiseSqrt(),
          solver.eigenvectors().transpose() * m * Eigen::Vector2d(1, 0)};
}

// The exact displacement, and strain times half the length, relative to the base.
Eigen::Vector2d exact_motion(double time) {
  const Modes given = modes();
  const exact::Accelerogram record = accelerogram();
  Eigen::Vector2d motion = Eigen::Vector2d::Zero();
  for (int mode = 0; mode < 2; ++mode)
    motion += given.participation(mode) * exact::oscillator_on_base(record, given.omega(mode), time).displacement *
              given.shapes.col(mode);
  return {motion(0), motion(1) * length / 2};
}

// Largest error at the samples over the largest motion.
double error_with(const std::string& integrator, int steps, const RecordFolder& folder, dda::Counters& counters) {
  const std::string joint = fmt::format(R"("law": "classical", "normal_spring": {})", spring);
  dda::Simulation simulation(shaken_block(joint, integrator, "small", steps, folder));
  const int between = steps / 270;
  double error = 0, largest = 0;
  for (int i = 1; i <= 270; ++i) {
    advance(simulation, between);
    const dda::State& state = simulation.state();
    const Eigen::Vector2d exact = exact_motion(state.time);
    const Eigen::Vector2d found(state.displacement[1](0) - state.displacement[0](0),
                                state.displacement[1](3) * length / 2);
    keep_largest(error, (found - exact).norm());
    keep_largest(largest, exact.norm());
  }
  counters += simulation.counters();
  return error / largest;
}

Outcome oscillator() {
  const RecordFolder folder;
  Outcome outcome;
  const std::array schemes{std::pair(R"("trapezoidal")", 2.0), std::pair(R"({"generalized_alpha": 0.8})", 2.0),
                           std::pair(R"("thesis")", 1.0)};
  for (const auto& [integrator, order] : schemes) {
    const int steps = order == 1 ? 270 * 160 : 270 * 20;
    const double coarse = error_with(integrator, steps, folder, outcome.counters);
    const double fine = error_with(integrator, 2 * steps, folder, outcome.counters);
    Assertion assertion =
        expect(fmt::format("motion relative to the base, {}, dt = {:.3g} s", integrator, end_time / (2 * steps)), "-")
            .is(fine)
            .against(0,
                     "two modes by Duhamel's integral of the record, exact between samples "
                     "(verification/exact/base_motion.h)")
            .absolutely()
            .within(order == 1 ? 5e-3 : 5e-4,
                    "largest error over the largest motion; falls with dt to the order beside");
    assertion.order = Order{std::log2(coarse / fine), order};
    outcome.assertions.push_back(assertion);
  }
  return outcome;
}

}  // namespace

std::vector<Case> base_shaking_cases() {
  return {{"base-shaking-oscillator",
           "An elastic block on springs on a base shaken by a record, against Duhamel's integral",
           {4},
           CaseLabel::fast,
           oscillator},
          {"base-shaking-glued-block",
           "A base follows the record of a file exactly, a block glued to it up to its elastic lag",
           {11},
           CaseLabel::fast,
           glued_block}};
}

}  // namespace verify
