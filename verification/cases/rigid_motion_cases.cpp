#include "verification/cases/rigid_motion_cases.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "engine/geometry/polygon.h"
#include "engine/model/current_outline.h"
#include "verification/exact/wave_speeds.h"
#include "verification/harness/histories.h"
#include "verification/harness/recorded_run.h"
#include "verification/suite/expect.h"

namespace verify {
namespace {

constexpr double round_off = 2.3e-16;
constexpr double standard_gravity = 9.81;

dda::Model lone_block(const dda::Integrator& integrator, double dt, int steps) {
  dda::Model model;
  model.materials = {{"rock", 2650, 50e9, 0.25, dda::PlaneState::stress}};
  model.blocks.emplace_back().shape.outer = {{0, 0}, {3, 0.2}, {3.1, 1}, {1.2, 1.1}, {1, 2.5}, {-0.1, 2.4}};
  dda::Stage stage;
  stage.integrator = integrator;
  stage.dt = dt;
  stage.duration = steps * dt;
  stage.solver = dda::SolverRequest::cholesky;
  model.stages = {stage};
  return model;
}

// The state at the end of the stage of `model`, which is finished; counts what the run did.
dda::State final_state(const dda::Model& model, Outcome& outcome) {
  dda::Simulation simulation(model);
  advance_to_end(simulation);
  outcome.counters += simulation.counters();
  return simulation.state();
}

std::vector<dda::Integrator> integrators() {
  return {dda::thesis_integrator(), dda::trapezoidal_integrator(), dda::hht_integrator(0.1),
          dda::generalized_alpha_integrator(0.8)};
}

Outcome free_fall() {
  constexpr int steps = 500;
  Outcome outcome;
  for (const dda::Integrator& integrator : integrators()) {
    dda::Model model = lone_block(integrator, 2e-3, steps);
    model.gravity = {0, -standard_gravity};
    dda::finish_model(model);
    const double fallen = -final_state(model, outcome).displacement[0](1);
    const double expected = exact::free_fall(standard_gravity, 1);
    outcome.assertions.push_back(expect("fall in 1 s, " + integrator.name, "m")
                                     .is(fallen)
                                     .against(expected, "g t^2/2")
                                     .within(steps * round_off, "one rounding a step"));
  }
  return outcome;
}

Outcome fall_with_velocity_factor() {
  constexpr int steps = 300;
  constexpr double dt = 1e-2;
  Outcome outcome;
  for (const double k01 : {0.9, 0.98}) {
    dda::Model model = lone_block(dda::thesis_integrator(), dt, steps);
    model.gravity = {0, -standard_gravity};
    model.stages[0].velocity_factor = k01;
    dda::finish_model(model);
    const double speed = -final_state(model, outcome).velocity[0](1);
    const double end = exact::velocity_after_steps(standard_gravity, dt, k01, steps);
    const double terminal = exact::terminal_velocity(standard_gravity, dt, k01).carried;
    outcome.assertions.push_back(expect(fmt::format("speed after {} steps, k01 = {}", steps, k01), "m/s")
                                     .is(speed)
                                     .against(k01 * end, "k01 (v + g dt) step by step")
                                     .off_by((speed - k01 * end) / end)
                                     .within(steps * round_off, "one rounding a step"));
    outcome.assertions.push_back(expect(fmt::format("terminal speed, k01 = {}", k01), "m/s")
                                     .is(speed)
                                     .against(terminal, "k01 g dt/(1 - k01)")
                                     .off_by((speed - terminal) / end)
                                     .within(std::pow(k01, steps) + steps * round_off,
                                             fmt::format("k01^{} is still to come, and one rounding a step", steps)));
  }
  return outcome;
}

// Farthest that a vertex is from where it was drawn.
double farthest(const dda::Polygon& turned, const dda::Polygon& drawn) {
  double distance = 0;
  for (std::size_t i = 0; i < turned.outer.size(); ++i)
    keep_largest(distance, (turned.outer[i] - drawn.outer[i]).norm());
  return distance;
}

Outcome free_spin() {
  constexpr int turns = 10;
  constexpr int steps_per_turn = 1000;
  constexpr int steps = turns * steps_per_turn;
  constexpr double angle = 2 * std::numbers::pi * turns;
  Outcome outcome;
  for (const dda::Integrator& integrator : integrators()) {
    dda::Model model = lone_block(integrator, 1e-3, steps);
    model.blocks[0].initial_spin = angle / (steps * 1e-3);
    model.materials[0].young = 1e21;  // the centrifugal force stretches it by less than round-off (see spin-stress)
    dda::finish_model(model);
    const dda::State state = final_state(model, outcome);
    const dda::Polygon& drawn = model.blocks[0].shape;
    const dda::Polygon turned = dda::current_outline(model, state, 0);
    const double turned_by = state.displacement[0](2);
    const double area = dda::area_moments(turned).area;
    const double drawn_area = model.blocks[0].moments.area;
    const double distance = farthest(turned, drawn);
    outcome.assertions.push_back(expect("angle after ten turns, " + integrator.name, "rad")
                                     .is(turned_by)
                                     .against(angle, "omega t")
                                     .within(steps * round_off, "one rounding a step"));
    outcome.assertions.push_back(
        expect("area after ten turns, " + integrator.name, "m2")
            .is(area)
            .against(drawn_area, "the area drawn; a linear update grows it by exp(4 pi^2/1000) a turn")
            .within(4 * steps * round_off, "round-off of the products of four matrices a step"));
    outcome.assertions.push_back(
        expect("farthest vertex from its place after ten turns, " + integrator.name, "m")
            .is(distance)
            .against(0, "whole turns bring every vertex back (error absolute)")
            .absolutely()
            .within(4 * steps * round_off * angle, "round-off of the angle and of a product a step"));
  }
  return outcome;
}

}  // namespace

std::vector<Case> rigid_motion_cases() {
  return {{"free-fall", "Free fall under four integrators", {1}, CaseLabel::fast, free_fall},
          {"fall-with-velocity-factor",
           "Fall with velocities cut by k01 a step: the terminal speed depends on dt",
           {2},
           CaseLabel::fast,
           fall_with_velocity_factor},
          {"free-spin", "Ten turns of a free block in 10,000 steps", {3}, CaseLabel::fast, free_spin}};
}

}  // namespace verify
