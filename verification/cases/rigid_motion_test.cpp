// Catalogue 1-3: free fall, fall with k01, free spin.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dda/geometry/polygon.h"
#include "dda/simulation/simulation.h"
#include "verification/exact/wave_speeds.h"

namespace verify {
namespace {

constexpr double round_off = 2.3e-16;

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

dda::State state_after(dda::Model model, int steps) {
  dda::finish_model(model);
  dda::Simulation simulation(std::move(model));
  for (int i = 0; i < steps; ++i) {
    if (simulation.step() != dda::Status::ok) ADD_FAILURE() << simulation.message();
  }
  return simulation.state();
}

std::vector<dda::Integrator> integrators() {
  return {dda::thesis_integrator(), dda::trapezoidal_integrator(), dda::hht_integrator(0.1),
          dda::generalized_alpha_integrator(0.8)};
}

TEST(Catalogue01, FreeFall) {
  constexpr int steps = 500;
  for (const dda::Integrator& integrator : integrators()) {
    dda::Model model = lone_block(integrator, 2e-3, steps);
    model.gravity = {0, -9.81};
    const double fallen = -state_after(std::move(model), steps).displacement[0](1);
    const double expected = exact::free_fall(9.81, 1);
    EXPECT_NEAR(fallen, expected, steps * round_off * expected) << integrator.name;  // one rounding a step
  }
}

TEST(Catalogue02, FallWithK01) {
  constexpr int steps = 300;
  for (const double k01 : {0.9, 0.98}) {
    dda::Model model = lone_block(dda::thesis_integrator(), 1e-2, steps);
    model.gravity = {0, -9.81};
    model.stages[0].velocity_factor = k01;
    const double speed = -state_after(std::move(model), steps).velocity[0](1);
    const double end = exact::velocity_after_steps(9.81, 1e-2, k01, steps);
    EXPECT_NEAR(speed, k01 * end, steps * round_off * end);
    EXPECT_NEAR(speed, exact::terminal_velocity(9.81, 1e-2, k01).carried,
                (std::pow(k01, steps) + steps * round_off) * end);
  }
}

TEST(Catalogue03, FreeSpin) {
  constexpr int turns = 10;
  constexpr int steps_per_turn = 1000;
  constexpr int steps = turns * steps_per_turn;
  for (const dda::Integrator& integrator : integrators()) {
    dda::Model model = lone_block(integrator, 1e-3, steps);
    const double spin = 2 * std::numbers::pi / (steps_per_turn * 1e-3);
    model.blocks[0].initial_spin = spin;
    dda::finish_model(model);
    const double area = model.blocks[0].moments.area;
    const dda::Polygon drawn = model.blocks[0].shape;
    const dda::State state = state_after(model, steps);
    const double angle = 2 * std::numbers::pi * turns;
    EXPECT_NEAR(state.displacement[0](2), angle, steps * round_off * angle) << integrator.name;
    dda::Polygon turned = drawn;
    for (dda::Vec2& vertex : turned.outer) vertex = dda::current_position(model, state, 0, vertex);
    // Round-off of a product of matrices a step. A linear update would have grown by exp(4 pi^2/steps_per_turn) a turn.
    EXPECT_NEAR(dda::area_moments(turned).area / area, 1, 4 * steps * round_off);
    for (std::size_t i = 0; i < turned.outer.size(); ++i)
      EXPECT_LT((turned.outer[i] - drawn.outer[i]).norm(), 4 * steps * round_off * angle);
  }
}

}  // namespace
}  // namespace verify
