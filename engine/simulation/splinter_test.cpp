// Splinters that tumble among blocks a thousand times their size: rock is not stepped more often for what weighs
// nothing, and a small stone that is what a scene is about is.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr int steps = 20;

// Stones of 1 m in a row on a base that is held, and one of side `small` that falls beside them and turns by 0.1 rad a
// step.
Model stones_beside(int stones, double small) {
  Model model;
  model.materials = {{"rock", 2500, 20e9, 0.25, PlaneState::stress}};
  model.blocks = {rectangle("base", -1, -1, stones + 4, 1)};
  for (int i = 0; i < stones; ++i) model.blocks.push_back(rectangle("stone " + std::to_string(i), 1.01 * i, 0, 1, 1));
  model.blocks.push_back(rectangle("small", stones + 1, 2, small, small));
  const Stage stage = stage_of(generalized_alpha_integrator(0), 1e-4, steps, Kinematics::finite);
  model.blocks.back().initial_spin = 0.1 / stage.dt;
  model.held_blocks.emplace_back().block = 0;
  model.gravity = {0, -9.81};
  model.stages = {stage};
  return model;
}

std::int64_t parts_taken(Model model) {
  Simulation simulation = simulation_of(std::move(model));
  while (!simulation.finished()) EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
  return simulation.counters().steps;
}

TEST(Splinter, TurnsWithoutCuttingTheStepsOfAllOthers) { EXPECT_EQ(parts_taken(stones_beside(3, 5e-4)), steps); }

// A turn of 0.1 is cut into sixteenths, the first power of two below 0.01.
TEST(Splinter, IsNoStoneThatIsAThousandthOfTheArea) { EXPECT_EQ(parts_taken(stones_beside(3, 0.03)), 16 * steps); }

TEST(Splinter, IsNoStoneBesideOneLargeBlockAlone) { EXPECT_EQ(parts_taken(stones_beside(1, 5e-4)), 16 * steps); }

}  // namespace
}  // namespace dda
