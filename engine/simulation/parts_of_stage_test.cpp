// In how many parts held blocks go: so many that in none of them they turn or move far.
#include "engine/simulation/parts_of_stage.h"

#include <gtest/gtest.h>

#include <utility>

#include "engine/simulation/projected_models.h"

namespace dda {
namespace {

// For a stage that moves a block of 2 x 0.5 m on the ground, with a cube of 0.5 m on it.
int parts_of(const Vec2& way) {
  Model model;
  model.materials = {rock()};
  model.joints = {dry_projected(0.7)};
  model.gravity = {0, -10};
  model.blocks = {rectangle("slab", 0, 0, 2, 0.5), rectangle("cube", 0.7, 0.5, 0.5, 0.5)};
  model.held_blocks.resize(1);
  model.held_blocks[0].amplitude = way;
  model.held_blocks[0].history = PiecewiseLinear{{0, 1}, {0, 1}};
  model.stages = {settling_stage(1e-6, 1)};
  Simulation simulation = simulation_of(std::move(model));
  EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
  return simulation.system().clock.parts.all;
}

TEST(PartsOfStage, AreOneWhereNothingMoves) { EXPECT_EQ(parts_of({0, 0}), 1); }

TEST(PartsOfStage, AreThirtyTwoForMotionsThatHardlyCount) { EXPECT_EQ(parts_of({1e-4, 0}), 32); }

// A thousandth of the cube's 0.5 m each.
TEST(PartsOfStage, MoveNothingByMoreThanAThousandthOfTheSmallestBlock) { EXPECT_EQ(parts_of({0, -0.0999}), 200); }

TEST(PartsOfStage, AreNoMoreThanAStageHasStepsFor) { EXPECT_EQ(parts_of({3, 0}), 300); }

}  // namespace
}  // namespace dda
