#include "verification/cases/joint_strength_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "verification/cases/contact_rig.h"
#include "verification/exact/joint_strength.h"
#include "verification/exact/wave_speeds.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

const dda::Material rock{"rock", 2600, 50e9, 0.2, dda::PlaneState::stress};

constexpr double degree = std::numbers::pi / 180;
constexpr std::array laws{dda::InterfaceLaw::classical, dda::InterfaceLaw::consistent};

std::string name_of(dda::InterfaceLaw law) { return law == dda::InterfaceLaw::classical ? "classical" : "consistent"; }

// ---- A block of 1 m x 2 m hung from one that is held.

constexpr double block_height = 2;
constexpr double hanging_time = 0.5;

struct Hung {
  double motion = 0;  // m, downwards from where its weight has put it, at the end
  double residual = 0;
};

Hung hang(dda::InterfaceLaw law, double tensile_strength, Outcome& outcome) {
  dda::Model model;
  model.materials = {rock};
  model.joints.resize(1);
  model.joints[0].law = law;
  model.joints[0].tensile_strength = tensile_strength;
  model.joints[0].cohesion = 1e6;
  hold_corners(model, add_box(model, 0, 0, 1, 1));
  add_box(model, 0, -block_height, 1, 0);
  model.gravity = {0, -standard_gravity};
  model.stages = {settling_stage(), moving_stage(dda::thesis_integrator(), 1e-3, hanging_time)};
  WatchedRun run(std::move(model));
  run.run_to(settling_time);
  const double start = run.state().displacement[1](1);
  run.run_to_end();
  outcome.counters += run.simulation().counters();
  return {start - run.state().displacement[1](1), run.energy_residual()};
}

Outcome hanging_block() {
  const double needed = exact::hanging_strength(rock.density, standard_gravity, block_height);
  const double expected = exact::free_fall(standard_gravity, hanging_time);
  Outcome outcome;
  for (const dda::InterfaceLaw law : laws) {
    const Hung holds = hang(law, 1.001 * needed, outcome);
    outcome.assertions.push_back(expect("motion of the block, strength 0.1 % above its weight, " + name_of(law), "m")
                                     .is(holds.motion)
                                     .against(0, "hangs while T > rho g H (error absolute)")
                                     .absolutely()
                                     .within(1e-12, "theory: none; round-off of forces over stiffness"));
    outcome.assertions.push_back(energy_assertion("hanging, " + name_of(law), holds.residual));
    const Hung falls = hang(law, 0.999 * needed, outcome);
    outcome.assertions.push_back(
        expect("fall in 0.5 s, strength 0.1 % below the weight, " + name_of(law), "m")
            .is(falls.motion)
            .against(expected, "g t^2/2, for T < rho g H")
            .within(1e-12, "one rounding a step: Eq. 5 falls exactly, from the step in which the joint breaks"));
    outcome.assertions.push_back(energy_assertion("falling, " + name_of(law), falls.residual));
  }
  return outcome;
}

// ---- Direct shear: a block of 1 m x 0.5 m on a base, pulled along the joint's own line so that nothing tilts.

// Without Poisson's ratio: a block that widens under its load shears the ends of its joint against each other.
const dda::Material stiff_sideways{"rock", 2600, 50e9, 0, dda::PlaneState::stress};
constexpr double width = 1;
constexpr int shear_steps = 20000;
constexpr double over_peak = 1.5;  // how far the pull goes on

dda::Model shear_box(const dda::JointMaterial& joint, double normal_stress, double peak) {
  constexpr double spring = 1e9;  // N/m, of each of two: soft, so that the pull hardly drops when the joint breaks
  dda::Model model;
  model.materials = {stiff_sideways};
  model.joints = {joint};
  hold_corners(model, add_box(model, -0.5, -1, 1.5, 0));
  add_box(model, 0, 0, width, 0.5);
  model.edge_loads = {{1, {width, 0.5}, {0, 0.5}, {0, -normal_stress}, {}}};
  const double travel = over_peak * peak * width / (2 * spring);
  const dda::PiecewiseLinear ramp{{settling_time, settling_time + shear_steps}, {0, 1}};
  for (const double x : {0.0, width}) model.supports.push_back({1, {x, 0}, true, false, spring, {travel, 0}, ramp});
  model.stages = {settling_stage(), moving_stage(dda::static_integrator(), 1, shear_steps)};
  return model;
}

// Shear force that the joint carries, N, whatever its law.
double shear_force(const dda::Simulation& simulation) {
  double force = 0;
  const dda::ContactSet& contacts = simulation.contacts();
  for (std::size_t i = 0; i < contacts.states.size(); ++i) {
    force += contacts.states[i].force(1);
    if (contacts.elements[i].law == dda::InterfaceLaw::classical) force += contacts.states[i].force(3);
  }
  return std::abs(force);
}

struct Sheared {
  double peak = 0;      // Pa
  double residual = 0;  // Pa
  double slip = 0;      // m, since the peak
  double rise = 0;      // m, since the peak
  double energy_residual = 0;
};

Assertion peak_assertion(const std::string& name, const Sheared& sheared, double peak) {
  return expect("peak shear strength, " + name, "Pa")
      .is(sheared.peak)
      .against(peak, "c + sigma tan f")
      .within(over_peak / shear_steps, "theory: the pull grows by this share of the peak a step");
}

Sheared shear(const dda::JointMaterial& joint, double normal_stress, double peak, Outcome& outcome) {
  WatchedRun run(shear_box(joint, normal_stress, peak));
  Sheared sheared;
  dda::Vec2 at_peak = dda::Vec2::Zero();
  while (!run.simulation().finished()) {
    run.step();
    sheared.residual = shear_force(run.simulation()) / width;
    const dda::Vec2 place = dda::point_displacement(run.simulation().model(), run.state(), 1, {width / 2, 0});
    if (sheared.residual > sheared.peak) at_peak = place;
    sheared.peak = std::max(sheared.peak, sheared.residual);
    sheared.slip = (place - at_peak).x();
    sheared.rise = (place - at_peak).y();
  }
  sheared.energy_residual = run.energy_residual();
  outcome.counters += run.simulation().counters();
  return sheared;
}

Outcome direct_shear() {
  dda::JointMaterial joint;
  joint.cohesion = 0.4e6;
  joint.friction_angle = 31 * degree;
  joint.tensile_strength = 1e5;
  Outcome outcome;
  for (const dda::InterfaceLaw law : laws) {
    joint.law = law;
    double energy_residual = 0;
    for (const double normal_stress : {0.0, 0.2e6, 0.5e6, 1e6, 2e6}) {
      const std::string name = fmt::format("normal stress {} MPa, {}", normal_stress / 1e6, name_of(law));
      const double peak = exact::shear_strength(joint.cohesion, joint.friction_angle, normal_stress);
      const double residual = exact::shear_strength(0, joint.friction_angle, normal_stress);
      const Sheared sheared = shear(joint, normal_stress, peak, outcome);
      outcome.assertions.push_back(peak_assertion(name, sheared, peak));
      outcome.assertions.push_back(
          expect("shear strength after the peak, " + name, "Pa")
              .is(sheared.residual)
              .against(residual, "sigma tan f (error over the peak)")
              .off_by((sheared.residual - residual) / peak)
              .within(1e-7, "measured 1.2e-8 at 2 MPa, in proportion to the stress over Young's modulus"));
      energy_residual = std::max(energy_residual, sheared.energy_residual);
    }
    outcome.assertions.push_back(energy_assertion("worst normal stress, " + name_of(law), energy_residual));
  }
  return outcome;
}

// Residual values below the peak's, of a joint with cohesion and of a dry one.
Outcome weakening_joint() {
  constexpr double normal_stress = 1e6;
  dda::JointMaterial joint;
  joint.law = dda::InterfaceLaw::classical;
  joint.friction_angle = 31 * degree;
  joint.residual_friction_angle = 20 * degree;
  Outcome outcome;
  for (const double cohesion : {0.4e6, 0.0}) {
    joint.cohesion = cohesion;
    joint.residual_cohesion = cohesion / 4;
    const std::string name = fmt::format("cohesion {} MPa", cohesion / 1e6);
    const double peak = exact::shear_strength(cohesion, joint.friction_angle, normal_stress);
    const double residual =
        exact::shear_strength(joint.residual_cohesion, *joint.residual_friction_angle, normal_stress);
    const Sheared sheared = shear(joint, normal_stress, peak, outcome);
    outcome.assertions.push_back(peak_assertion(name, sheared, peak));
    outcome.assertions.push_back(
        expect("residual shear strength, " + name, "Pa")
            .is(sheared.residual)
            .against(residual, "c_r + sigma tan f_r")
            .within(1e-7, "stress over Young's modulus, 2e-5, times the joint's turn under its slip"));
    outcome.assertions.push_back(energy_assertion(name, sheared.energy_residual));
  }
  return outcome;
}

// A joint that rides up as it slides, at constant normal stress: freely, and up to a given slip.
Outcome dilating_joint() {
  constexpr double normal_stress = 1e6;
  dda::JointMaterial joint;
  joint.law = dda::InterfaceLaw::classical;
  joint.cohesion = 0.4e6;
  joint.friction_angle = 31 * degree;
  joint.dilation_angle = 8 * degree;
  const double peak = exact::shear_strength(joint.cohesion, joint.friction_angle, normal_stress);
  Outcome outcome;
  for (const double reach : {std::numeric_limits<double>::infinity(), 1e-4}) {
    joint.zero_dilation_slip = reach;
    const std::string name = fmt::format("dilation up to a slip of {} m", reach);
    const Sheared sheared = shear(joint, normal_stress, peak, outcome);
    const double expected = std::tan(joint.dilation_angle) * std::min(sheared.slip, reach);
    // The shear springs of the peak (4e11 N/m, both) give back what they held; the slip is longer by that.
    const double given_back = (sheared.peak - sheared.residual) * width / (8 * stiff_sideways.young);
    outcome.assertions.push_back(
        expect("rise, " + name, "m")
            .is(sheared.rise)
            .against(expected, "slip tan d")
            .within(2 * given_back / sheared.slip,
                    "theory: slip as seen from outside is short of that of the joint by what its springs "
                    "give back when the peak has passed"));
    outcome.assertions.push_back(expect("shear strength while it rises, " + name, "Pa")
                                     .is(sheared.residual)
                                     .against(normal_stress * std::tan(joint.friction_angle), "sigma tan f")
                                     .off_by(sheared.residual / (normal_stress * std::tan(joint.friction_angle)) - 1)
                                     .within(1e-7, "as without dilation: the normal stress is given"));
    outcome.assertions.push_back(energy_assertion(name, sheared.energy_residual));
  }
  return outcome;
}

}  // namespace

std::vector<Case> joint_strength_cases() {
  return {{"hanging-block", "Block hung by the tensile strength of its joint", {23}, CaseLabel::fast, hanging_block},
          {"direct-shear", "Joint in direct shear under several normal stresses", {23}, CaseLabel::fast, direct_shear},
          {"weakening-joint", "Joint whose strength falls to residual values", {23}, CaseLabel::fast, weakening_joint},
          {"dilating-joint", "Joint that rides up as it slides", {23}, CaseLabel::fast, dilating_joint}};
}

}  // namespace verify
