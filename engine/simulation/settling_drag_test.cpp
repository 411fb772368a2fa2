// Which blocks of rock that settles are loose: those that go by themselves, not those that what they lie on takes
// along.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "engine/simulation/run_so_far.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr double standard_gravity = 9.81;
constexpr double pebble_size = 0.01;  // m
constexpr int courses = 5;

Stage settling() {
  Stage stage = stage_of(static_integrator(), 0, 0, Kinematics::finite);
  stage.equilibrium = 1e-9;
  return stage;
}

// Soft ground of five blocks of 1 m, with a pebble on top of it.
Model pebble_on_soft_ground() {
  Model model;
  model.materials = {{"clay", 2000, 5e6, 0, PlaneState::stress}};
  model.joints = {JointMaterial{}};
  model.joints[0].friction_angle = 0.5;
  model.blocks = {rectangle("floor", -1, -1, 3, 1)};
  for (int i = 0; i < courses; ++i) model.blocks.push_back(rectangle("ground " + std::to_string(i), 0, i, 1, 1));
  model.blocks.push_back(rectangle("pebble", 0.5 - pebble_size / 2, courses, pebble_size, pebble_size));
  model.held_blocks.emplace_back().block = 0;
  model.gravity = {0, -standard_gravity};
  model.stages = {settling()};
  return model;
}

// The ground sinks by rho g h^2/(2 E) = 49 mm and a little for its springs, five times the pebble.
TEST(SettlingDrag, PebbleOnGroundThatSinksIsNotLoose) {
  Simulation simulation = simulation_of(pebble_on_soft_ground());
  while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
  EXPECT_TRUE(simulation.results().loose.empty());
  EXPECT_LE(simulation.results().out_of_balance[0], 1e-9);
  const double top = current_position(simulation.model(), simulation.state(), courses, {0.5, courses}).y();
  const double foot = current_position(simulation.model(), simulation.state(), courses + 1, {0.5, courses}).y();
  EXPECT_LT(top, courses - 4 * pebble_size);
  EXPECT_NEAR(foot, top, 1e-3 * pebble_size);
}

// What ground carries goes with it where it is moved, in the steps that the stage shares its way among.
TEST(SettlingDrag, PebbleOnAFloorThatIsMovedIsNotLoose) {
  Model model = pebble_on_soft_ground();
  model.held_blocks[0].amplitude = {0.3, 0};
  model.held_blocks[0].history = PiecewiseLinear{{0, 1}, {0, 1}};
  model.stages[0].duration = 1;
  Simulation simulation = simulation_of(std::move(model));
  while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
  EXPECT_TRUE(simulation.results().loose.empty());
}

}  // namespace
}  // namespace dda
