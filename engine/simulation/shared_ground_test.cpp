// What blocks have in common at the end of a run is told by their outlines, less what the joints between give way.
#include "engine/simulation/shared_ground.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "engine/simulation/simulation_models.h"
#include "engine/simulation/stage_end.h"

namespace dda {
namespace {

// A block with its tip down that touches the held floor, put `depth` into it behind the back of its contact.
Simulation tip_in_floor(double depth, bool is_held = false,
                        const Integrator& integrator = generalized_alpha_integrator(0)) {
  Model model;
  model.materials = {{"rock", 2600, 20e9, 0.2, PlaneState::stress}};
  model.joints = {JointMaterial{}};
  Block wedge;
  wedge.name = "wedge";
  wedge.shape.outer = {{0, 0}, {1, 1}, {-1, 1}};  // 1 m2
  model.blocks = {rectangle("floor", -5, -1, 10, 1), wedge};
  model.held_blocks.emplace_back().block = 0;
  if (is_held) model.held_blocks.emplace_back().block = 1;
  model.stages = {stage_of(integrator, 1e-3, 1, Kinematics::finite)};
  Simulation simulation = simulation_of(std::move(model));
  State state = simulation.state();
  state.displacement[1](1) = -depth;
  const auto saved = simulation.save();
  simulation.restore(std::move(state), saved);
  return simulation;
}

TEST(SharedGround, IsFoundWhereNoContactKnowsOfIt) {
  for (const double depth : {3e-3, 1e-2, 0.2}) {
    const std::vector<SharedGround> found = shared_ground(tip_in_floor(depth).system());
    ASSERT_EQ(found.size(), 1U) << depth;
    EXPECT_EQ(std::pair(found[0].block_a, found[0].block_b), std::pair(0, 1));
    EXPECT_NEAR(found[0].depth, depth, 2e-3 * depth);  // ten binary digits
    EXPECT_NEAR(found[0].share, depth, 2e-3 * depth) << "of 1 m";
    EXPECT_NEAR((found[0].place - Vec2(0, -depth)).norm(), 0, 1e-9);
  }
}

TEST(SharedGround, IsNoneWhereBlocksTouchOrAreHeldInEachOther) {
  EXPECT_TRUE(shared_ground(tip_in_floor(0).system()).empty());
  EXPECT_TRUE(shared_ground(tip_in_floor(1e-3).system()).empty());
  EXPECT_FALSE(shared_ground(tip_in_floor(1e-3).system(), 5e-4).empty());
  EXPECT_TRUE(shared_ground(tip_in_floor(0.2, true).system()).empty());
}

// What a stage in motion passes through is told at the end of the run alone.
TEST(SharedGround, IsNotedAtTheEndOfStaticStages) {
  const auto noted = [](const Integrator& integrator) {
    StageResults results(1);
    note_results(tip_in_floor(1e-2, false, integrator).system(), 0, results);
    return results.shared_ground;
  };
  EXPECT_TRUE(noted(generalized_alpha_integrator(0)).empty());
  const std::vector<SharedGroundOfStage> of_static = noted(static_integrator());
  ASSERT_EQ(of_static.size(), 1U);
  EXPECT_EQ(of_static[0].stage, 0);
  EXPECT_EQ(of_static[0].pairs, 1);
  EXPECT_NEAR(of_static[0].worst.depth, 1e-2, 2e-5);
}

// A box of 1 m that its joint lets sink in by up to 5 cm: contacts know, and say so where it is too much.
TEST(SharedGround, IsNoneWhereSpringsGiveWay) {
  Model model;
  model.materials = {{"rock", 2600, 20e9, 0.2, PlaneState::stress}};
  model.joints = {JointMaterial{}};
  model.joints[0].normal_stiffness = 1e6;
  model.blocks = {rectangle("floor", -5, -1, 10, 1), rectangle("box", 0, 0, 1, 1)};
  model.held_blocks.emplace_back().block = 0;
  model.gravity = {0, -9.81};
  model.stages = {stage_of(generalized_alpha_integrator(0), 1e-3, 150, Kinematics::finite)};
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 150);
  EXPECT_LT(simulation.state().displacement[1](1), -0.02);
  EXPECT_TRUE(shared_ground(simulation.system()).empty());
}

// A box of 1 m that lies 3 cm deep in the floor, as its contacts have forgiven: each of their springs closes deeper by
// as much, and all is in balance.
TEST(SharedGround, IsGivenBackBeforeAStageThatSettlesIsOver) {
  Model model;
  model.materials = {{"rock", 2600, 20e9, 0.2, PlaneState::stress}};
  model.joints = {JointMaterial{}};
  model.joints[0].friction_angle = 0.5;
  model.joints[0].normal_stiffness = model.joints[0].shear_stiffness = 1e8;  // so soft that it does not settle at once
  model.blocks = {rectangle("floor", -5, -1, 10, 1), rectangle("box", 0, 0, 1, 1)};
  model.held_blocks.emplace_back().block = 0;
  model.gravity = {0, -9.81};
  model.stages = {stage_of(static_integrator(), 0, 0, Kinematics::finite)};
  model.stages[0].equilibrium = 1e-9;
  Simulation simulation = simulation_of(std::move(model));
  State state = simulation.state();
  state.displacement[1](1) = -0.03;
  const auto saved = simulation.save();
  simulation.restore(std::move(state), saved);
  ASSERT_FALSE(shared_ground(simulation.system()).empty());
  while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
  EXPECT_LT(simulation.results().out_of_balance[0], 1e-9);
  EXPECT_TRUE(simulation.results().shared_ground.empty());
  // Its last two thousandths are within what is tolerated.
  EXPECT_NEAR(simulation.state().displacement[1](1), 0, tolerated_share);
  // The deepest penetration is that of the end, under the weight, and not what it was on the way there.
  EXPECT_NEAR(simulation.deepest_penetration().share, 2600 * 9.81 / 1e8, 1e-6);
  EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
}

}  // namespace
}  // namespace dda
