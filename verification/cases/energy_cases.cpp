#include "verification/cases/energy_cases.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "engine/simulation/simulation.h"
#include "verification/harness/histories.h"
#include "verification/harness/recorded_run.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

constexpr double gravity = 9.81;

dda::Block box(const std::string& name, double left, double bottom, double right, double top) {
  dda::Block block;
  block.name = name;
  block.shape.outer = {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
  return block;
}

dda::Stage steps_of(const dda::Integrator& integrator, double dt, double duration) {
  dda::Stage stage;
  stage.integrator = integrator;
  stage.dt = dt;
  stage.duration = duration;
  stage.solver = dda::SolverRequest::cholesky;
  return stage;
}

// Bricks with some strength on a shaken floor, thrown and pushed so that joints break, slide, open and close; one side
// of the floor has an absorbing edge, contacts are damped and velocities decay: every entry of the ledger has
// something.
dda::Model everything(const dda::Integrator& integrator) {
  dda::Model model;
  model.materials = {{"rock", 2600, 5e9, 0.2, dda::PlaneState::stress}};
  dda::JointMaterial joint;
  joint.friction_angle = 0.5;
  joint.cohesion = 2e4;
  joint.tensile_strength = 1e4;
  joint.contact_damping = 0.1;
  model.joints = {joint};
  model.blocks = {box("floor", -1, -1, 3, 0), box("low", 0, 0, 1, 0.5), box("high", 0.2, 0.5, 1.2, 1)};
  model.blocks[2].initial_velocity = {0.8, 0.4};
  model.blocks[2].initial_spin = -0.3;
  model.blocks[1].initial_stress = {-1e4, 2e4, 5e3};
  model.gravity = {0, -gravity};
  model.supports = {{0, {-1, -1}, true, true, 1e11, {2e-3, 1e-3}, dda::SineCycles{5, 10, 0}},
                    {0, {3, -1}, true, true, 1e11, {2e-3, 0}, dda::SineCycles{5, 10, 0}}};
  model.point_loads = {{2, {1.2, 0.75}, {-2e3, 0}, dda::SineCycles{8, 10, 0}}};
  model.viscous_edges = {{0, {-1, 0}, {-1, -1}, 5e6, 3e6}};
  model.stages = {steps_of(integrator, 5e-4, 0.6)};
  model.stages[0].damping_rate = 0.5;
  dda::finish_model(model);
  return model;
}

Outcome every_entry() {
  Outcome outcome;
  const std::vector<std::pair<std::string, dda::Integrator>> integrators = {
      {"thesis", dda::thesis_integrator()},
      {"generalized_alpha 0", dda::generalized_alpha_integrator(0)},
      {"generalized_alpha 0.8", dda::generalized_alpha_integrator(0.8)},
      {"energy_conserving", dda::energy_conserving_integrator()}};
  for (const auto& [name, integrator] : integrators) {
    dda::Simulation simulation(everything(integrator));
    double worst = 0;
    while (!simulation.finished()) {
      advance(simulation, 1);
      keep_largest(worst, simulation.energy().relative_residual());
    }
    outcome.counters += simulation.counters();
    outcome.assertions.push_back(
        expect("energy residual over the largest entry, worst step, " + name, "-")
            .is(worst)
            .against(0,
                     "work = change of kinetic, strain and contact energy + friction + dashpots + damping "
                     "+ numerical dissipation (error absolute)")
            .absolutely()
            .within(1e-8, "promised; round-off of the solves is 1e-12"));
  }
  return outcome;
}

// A box thrown along the floor, at rest on it before: what it had goes into friction.
Outcome sliding_to_rest() {
  constexpr double speed = 0.9;
  constexpr double friction = 0.4;
  constexpr double dt = 1e-3;
  dda::Model model;
  model.materials = {{"rock", 2600, 5e9, 0.2, dda::PlaneState::stress}};
  dda::JointMaterial joint;
  joint.law = dda::InterfaceLaw::classical;
  joint.friction_angle = std::atan(friction);
  model.joints = {joint};
  model.blocks = {box("floor", -5, -1, 5, 0), box("box", -1, 0, 1, 0.5)};
  model.blocks[1].initial_velocity = {speed, 0};
  model.gravity = {0, -gravity};
  for (const dda::Vec2& corner : model.blocks[0].shape.outer)
    model.supports.push_back({0, corner, true, true, 1e12, dda::Vec2::Zero(), {}});
  model.stages = {steps_of(dda::thesis_integrator(), dt, 0.4)};
  dda::finish_model(model);
  dda::Simulation simulation(model);
  advance_to_end(simulation);
  const dda::EnergyLedger& energy = simulation.energy();
  const double kinetic = 2600 * speed * speed / 2;
  Outcome outcome;
  outcome.counters = simulation.counters();
  // Eq. 5 moves a block on by its speed at the end of the step: of m (v0^2 - v1^2)/2 it takes m (v0 - v1)^2/2 itself.
  const double by_friction = kinetic * (1 - dt * friction * gravity / speed);
  outcome.assertions.push_back(
      expect("friction and numerical dissipation after a slide to rest", "J/m")
          .is(energy.friction + energy.numerical)
          .against(kinetic, "m v0^2/2")
          .within(1e-3, "the weight, put on at once, sinks in by 1e-6 m and rings: 1e-4 of the energy"));
  outcome.assertions.push_back(expect("friction after a slide to rest", "J/m")
                                   .is(energy.friction)
                                   .against(by_friction, "m v0^2/2 (1 - mu g dt/v0) under Eq. 5")
                                   .within(1e-3, "as above"));
  outcome.assertions.push_back(expect("energy residual over the largest entry", "-")
                                   .is(energy.relative_residual())
                                   .against(0, "0 (error absolute)")
                                   .absolutely()
                                   .within(1e-8, "promised"));
  return outcome;
}

}  // namespace

std::vector<Case> energy_cases() {
  return {
      {"energy-every-entry",
       "Joints break, slide, open and close: the energy ledger closes",
       {8},
       CaseLabel::fast,
       every_entry},
      {"energy-friction", "A box slides to rest: friction takes what it had", {8}, CaseLabel::fast, sliding_to_rest}};
}

}  // namespace verify
