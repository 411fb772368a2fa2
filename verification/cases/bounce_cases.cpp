#include "verification/cases/bounce_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/simulation/simulation.h"
#include "verification/exact/bounce.h"
#include "verification/harness/recorded_run.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

constexpr double gravity = 9.81;
constexpr double density = 2600;
constexpr double young = 5e9;
constexpr double spring = 2e7;  // N/m, of each of the two corners
constexpr double height = 0.05;

dda::Block box(const std::string& name, double left, double bottom, double right, double top) {
  dda::Block block;
  block.name = name;
  block.shape.outer = {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
  return block;
}

// A box of 1 m above a floor that is held at its corners.
dda::Model falling_box(double dt) {
  dda::Model model;
  model.materials = {{"rock", density, young, 0.2, dda::PlaneState::stress}};
  dda::JointMaterial joint;
  joint.law = dda::InterfaceLaw::classical;
  joint.normal_spring = spring;
  model.joints = {joint};
  model.blocks = {box("floor", -2, -1, 3, 0), box("box", 0, height, 1, 1 + height)};
  model.gravity = {0, -gravity};
  for (const dda::Vec2& corner : model.blocks[0].shape.outer)
    model.supports.push_back({0, corner, true, true, 5e13, dda::Vec2::Zero(), {}});
  dda::Stage stage;
  stage.integrator = dda::energy_conserving_integrator();
  stage.dt = dt;
  stage.duration = 3 * std::sqrt(2 * height / gravity);  // falls, and comes back up within twice that
  stage.solver = dda::SolverRequest::cholesky;
  model.stages = {stage};
  dda::finish_model(model);
  return model;
}

struct Bounce {
  double rebound = 0;   // m, highest point after the impact above the point of contact
  double deepest = 0;   // m
  double residual = 0;  // of the energy ledger over the work of gravity, worst of all steps
  double numerical = 0;
};

Bounce bounce(double dt, Outcome& outcome) {
  dda::Simulation simulation(falling_box(dt));
  Bounce result;
  double lowest = 0;
  double highest_after = -height;
  const double work = density * gravity * height;
  while (!simulation.finished()) {
    advance(simulation, 1);
    // The corner's own motion: the box's shape follows the impact.
    const double corner = dda::current_position(simulation.model(), simulation.state(), 1, {0, height}).y();
    const double centre = simulation.state().displacement[1](1);
    lowest = std::min(lowest, corner);
    if (lowest < 0) highest_after = std::max(highest_after, centre);
    result.residual = std::max(result.residual, std::abs(simulation.energy().residual()) / work);
  }
  result.rebound = height + highest_after;
  result.deepest = -lowest;
  result.numerical = simulation.energy().numerical / work;
  outcome.counters += simulation.counters();
  return result;
}

Outcome elastic_bounce() {
  Outcome outcome;
  const exact::SpringImpact impact{density, 2 * spring, std::sqrt(2 * gravity * height), gravity};
  const std::string vibration =
      "promised; the box keeps (impact frequency/its own)^2 of the energy as vibration, 1e-4 or so";
  for (const double dt : {2e-3, 1e-3, 3e-4, 1e-4}) {
    const Bounce result = bounce(dt, outcome);
    const std::string at = fmt::format(", dt = {} ms", 1e3 * dt);
    outcome.assertions.push_back(expect("rebound height" + at, "m")
                                     .is(result.rebound)
                                     .against(height, "height of the fall: an elastic impact keeps the energy")
                                     .within(1e-3, vibration));
    outcome.assertions.push_back(expect("energy added or taken by time integration over the work of gravity" + at, "-")
                                     .is(result.numerical)
                                     .against(0, "0 (error absolute)")
                                     .absolutely()
                                     .within(1e-6, "gaps measured anew every step: squares of the strains, 1e-7"));
    outcome.assertions.push_back(expect("energy residual over the work of gravity" + at, "-")
                                     .is(result.residual)
                                     .against(0, "0 (error absolute)")
                                     .absolutely()
                                     .within(1e-8, "promised"));
    if (dt > 1e-3) continue;
    const double inertia = impact.frequency() * impact.frequency() * dt * dt / 8;
    outcome.assertions.push_back(
        expect("largest penetration of a corner" + at, "m")
            .is(result.deepest)
            .against(impact.deepest(), "m x'' = -k x - m g")
            .within(inertia + 2 * spring / young,
                    "omega^2 dt^2/8, the peak between two steps, and springs over the box's stiffness"));
  }
  return outcome;
}

}  // namespace

std::vector<Case> bounce_cases() {
  return {
      {"elastic-bounce", "A box dropped onto springs comes back to its height", {5}, CaseLabel::fast, elastic_bounce}};
}

}  // namespace verify
