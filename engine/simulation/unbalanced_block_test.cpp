// What becomes of a run when a static stage has blocks without equilibrium, and what is said of them.
#include "engine/simulation/unbalanced_block.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "engine/simulation/memory_test_support.h"
#include "engine/simulation/run_so_far.h"
#include "engine/simulation/simulation_models.h"
#include "engine/simulation/snapshot.h"

namespace dda {
namespace {

constexpr double gravity = 9.81;

// Finds its own steps.
Stage settling(OnUnbalanced what = OnUnbalanced::automatic) {
  Stage stage;
  stage.integrator = static_integrator();
  stage.equilibrium = 1e-9;
  stage.solver = SolverRequest::cholesky;
  stage.on_unbalanced = what;
  return stage;
}

Stage moving() { return stage_of(generalized_alpha_integrator(0), 1e-3, 5, Kinematics::finite); }

// Three boxes on each other on a held floor, and a small one that hangs in the air beside them, block 4.
Model boxes_and_a_stone() {
  Model model;
  model.materials = {{"rock", 2600, 20e9, 0.2, PlaneState::stress}};
  model.joints = {JointMaterial{}};
  model.joints[0].friction_angle = 0.5;
  model.blocks = {rectangle("floor", -2, -1, 8, 1), rectangle("low", 0, 0, 1, 1), rectangle("middle", 0.1, 1, 1, 1),
                  rectangle("high", 0, 2, 1, 1), rectangle("stone", 4.5, 1, 0.1, 0.1)};
  model.held_blocks.emplace_back().block = 0;
  model.gravity = {0, -gravity};
  return model;
}

constexpr int stone = 4;

// A box on a floor steeper than its friction: the floor carries it, and it slides for ever.
Model sliding_box() {
  Model model = boxes_and_a_stone();
  model.blocks.resize(2);
  model.joints[0].friction_angle = 0.3;
  model.gravity = gravity * Vec2(std::sin(0.4), -std::cos(0.4));
  return model;
}

Status status_at_end(Simulation& simulation) {
  Status status = Status::ok;
  while (!simulation.finished() && status == Status::ok) status = simulation.step();
  return status;
}

Simulation with_stages(Model model, std::vector<Stage> stages) {
  model.stages = std::move(stages);
  for (std::size_t i = 0; i < model.stages.size(); ++i) model.stages[i].name = "stage " + std::to_string(i + 1);
  return simulation_of(std::move(model));
}

TEST(UnbalancedBlocks, LooseOnesEndARunWhereNoStageFollowsUnlessItIsToldToGoOn) {
  Simulation automatic = with_stages(boxes_and_a_stone(), {settling()});
  EXPECT_EQ(status_at_end(automatic), Status::not_in_equilibrium);
  EXPECT_EQ(unbalanced_end(automatic), automatic.message());
  Simulation told = with_stages(boxes_and_a_stone(), {settling(OnUnbalanced::carry_on)});
  EXPECT_EQ(status_at_end(told), Status::ok) << told.message();
  EXPECT_TRUE(told.finished());
  EXPECT_EQ(unbalanced_end(told), "");
  for (const Simulation* each : {&automatic, &told}) {
    ASSERT_EQ(each->results().loose.size(), 1U);
    EXPECT_EQ(each->results().loose[0].block, stone);
  }
}

// A hundred times as large, with a stone of `size` (m) at this height (m) above the floor.
Model large_boxes_and_a_stone(double size, double height) {
  Model model = boxes_and_a_stone();
  for (Block& block : model.blocks)
    for (Vec2& corner : block.shape.outer) corner *= 100;
  model.blocks[stone] = rectangle("stone", 450, height, size, size);
  return model;
}

// However light it is beside the others: in the air, out of balance by all of its weight, it was less than the 1e-9 of
// theirs that are asked for. On the floor it is held by less than what passes neglect beside the forces of others.
TEST(UnbalancedBlocks, AStoneIsLooseInTheAirAndHeldByTheFloorHoweverLight) {
  for (const double size : {1e-1, 1e-2, 1e-3}) {
    Simulation in_the_air = with_stages(large_boxes_and_a_stone(size, 100), {settling()});
    EXPECT_EQ(status_at_end(in_the_air), Status::not_in_equilibrium) << size;
    ASSERT_EQ(in_the_air.results().loose.size(), 1U) << size;
    EXPECT_EQ(in_the_air.results().loose[0].block, stone);
    Simulation on_the_floor = with_stages(large_boxes_and_a_stone(size, 0), {settling()});
    EXPECT_EQ(status_at_end(on_the_floor), Status::ok) << size << on_the_floor.message();
  }
}

// Bonded rock of 6 blocks a unit of height, six times as long as high, clamped on the left, with a force down on its
// right end, of a Poisson's ratio at which volumes are 500 times as stiff as shapes.
Model nearly_incompressible_cantilever() {
  constexpr int rows = 8, columns = 6 * rows;
  constexpr double young = 20e9, side = 0.5;
  Model model;
  model.materials = {{"rock", 2500, young, 0.499, PlaneState::strain}};
  model.joints = {bond(InterfaceLaw::consistent)};
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      model.blocks.push_back(rectangle("", side * column, side * row, side, side));
  for (int row = 0; row < rows; ++row) {
    model.supports.push_back({row * columns, {0, side * (row + 0.5)}, true, true, 1000 * young, Vec2::Zero(), {}});
    model.point_loads.push_back({(row + 1) * columns - 1, {side * columns, side * (row + 0.5)}, {0, -5e3}, {}});
  }
  return model;
}

// What is left out of balance is then some 1.5e-9 of the load, which no further step makes less.
TEST(UnbalancedBlocks, RoundOffOfBondedRockIsNoForce) {
  Stage stage = settling();
  stage.kinematics = Kinematics::small;
  Simulation simulation = with_stages(nearly_incompressible_cantilever(), {stage});
  EXPECT_EQ(status_at_end(simulation), Status::ok) << simulation.message();
  EXPECT_LT(simulation.counters().steps, 100);
}

TEST(UnbalancedBlocks, LooseOnesEndARunBeforeItsLastStageWhereItIsToldToStop) {
  Simulation automatic = with_stages(boxes_and_a_stone(), {settling(), moving()});
  EXPECT_EQ(status_at_end(automatic), Status::ok) << automatic.message();
  Simulation told = with_stages(boxes_and_a_stone(), {settling(OnUnbalanced::stop), moving()});
  EXPECT_EQ(status_at_end(told), Status::not_in_equilibrium);
  EXPECT_EQ(stages_done(told), 1U);
  EXPECT_NE(told.message().find("static stage \"stage 1\" has no equilibrium for block \"stone\""), std::string::npos)
      << told.message();
}

// Where all blocks are held there is nothing to be told.
TEST(UnbalancedBlocks, ThatAreNotThereChangeNothing) {
  Model model = boxes_and_a_stone();
  model.blocks.pop_back();
  std::vector<std::vector<std::byte>> memories;
  for (const OnUnbalanced what : {OnUnbalanced::automatic, OnUnbalanced::carry_on, OnUnbalanced::stop}) {
    Simulation simulation = with_stages(model, {settling(what), moving()});
    EXPECT_EQ(status_at_end(simulation), Status::ok) << simulation.message();
    EXPECT_TRUE(simulation.results().loose.empty());
    memories.push_back(memory_of(simulation));
  }
  EXPECT_EQ(memories[1], memories[0]);
  EXPECT_EQ(memories[2], memories[0]);
}

// One step is not enough: forces are out of balance.
TEST(UnbalancedBlocks, OutOfBalanceEndARunUnlessItIsToldToGoOn) {
  for (const OnUnbalanced what : {OnUnbalanced::automatic, OnUnbalanced::stop, OnUnbalanced::carry_on}) {
    Stage short_stage = settling(what);
    short_stage.dt = short_stage.duration = 1e-5;
    Model model = boxes_and_a_stone();
    model.blocks.pop_back();
    Simulation simulation = with_stages(std::move(model), {short_stage, moving()});
    const bool goes_on = what == OnUnbalanced::carry_on;
    EXPECT_EQ(status_at_end(simulation), goes_on ? Status::ok : Status::not_in_equilibrium) << simulation.message();
    EXPECT_EQ(stages_done(simulation), goes_on ? 2U : 1U);
    ASSERT_FALSE(simulation.results().unbalanced.empty());
    for (const UnbalancedBlock& each : simulation.results().unbalanced) {
      EXPECT_EQ(each.stage, 0);
      EXPECT_NE(each.block, 0);  // which is held
    }
    EXPECT_TRUE(simulation.results().loose.empty());
  }
}

// A stone in the air has no face. A box that slides has that to the floor: friction and pressure there are those of a
// block on a slope.
TEST(UnbalancedBlocks, AreListedWithTheFacesThatHoldThem) {
  Simulation hanging = with_stages(boxes_and_a_stone(), {settling(OnUnbalanced::carry_on)});
  ASSERT_EQ(status_at_end(hanging), Status::ok);
  EXPECT_TRUE(hanging.results().loose.at(0).faces.empty());
  EXPECT_NE(described(hanging.model(), hanging.results().loose[0]).find("26 kg/m, held by no face"), std::string::npos);
  Simulation sliding = with_stages(sliding_box(), {settling(OnUnbalanced::carry_on)});
  ASSERT_EQ(status_at_end(sliding), Status::ok);
  ASSERT_EQ(sliding.results().loose.size(), 1U);
  const UnbalancedBlock& box = sliding.results().loose[0];
  ASSERT_EQ(box.faces.size(), 1U);
  EXPECT_EQ(box.faces[0].neighbour, 0);
  const double across = 2600 * gravity * std::cos(0.4);
  EXPECT_NEAR(box.faces[0].force.y() / across, 1, 1e-6);  // stresses turn with strains of 1e-6
  EXPECT_NEAR(box.faces[0].force.x() / across, -std::tan(0.3), 1e-6);
  EXPECT_NEAR(box.faces[0].place.x(), box.place.x(), 1e-3);
  EXPECT_NEAR(box.faces[0].place.y(), 0, 1e-3);
  EXPECT_NE(described(sliding.model(), box).find("held by \"floor\" at ("), std::string::npos);
}

// Stopped anywhere, within the stage with the loose block and between the stages, a run goes on to the same bits, and
// its lists are whole.
TEST(UnbalancedBlocks, AreRememberedByRunsThatGoOn) {
  for (const Model& drawn : {boxes_and_a_stone(), sliding_box()}) {
    const std::vector<Stage> stages = {settling(OnUnbalanced::carry_on), settling(OnUnbalanced::carry_on), moving()};
    Simulation whole = with_stages(drawn, stages);
    std::vector<State> states;
    std::vector<std::vector<std::byte>> snapshots;
    whole.watch().between = [&] {
      states.push_back(whole.state());
      snapshots.push_back(save(whole));
    };
    while (!whole.finished()) {
      ASSERT_EQ(whole.step(), Status::ok) << whole.message();
      if (whole.state().step % 7 != 0) continue;
      states.push_back(whole.state());
      snapshots.push_back(save(whole));
    }
    EXPECT_EQ(whole.results().loose.size(), 2U);  // in either stage
    ASSERT_GT(snapshots.size(), 4U);
    for (std::size_t i = 0; i < snapshots.size(); ++i) {
      Simulation resumed = with_stages(drawn, stages);
      restore(resumed, states[i], snapshots[i]);
      while (!resumed.finished()) ASSERT_EQ(resumed.step(), Status::ok) << resumed.message();
      EXPECT_EQ(memory_of(resumed), memory_of(whole)) << i;
    }
  }
}

// A run that has ended so is told so when it is restored.
TEST(UnbalancedBlocks, EndARunForWhoeverRestoresIt) {
  const std::vector<Stage> stages = {settling(OnUnbalanced::stop), moving()};
  Simulation whole = with_stages(boxes_and_a_stone(), stages);
  EXPECT_EQ(unbalanced_end(whole), "");
  ASSERT_EQ(status_at_end(whole), Status::not_in_equilibrium);
  Simulation restored = with_stages(boxes_and_a_stone(), stages);
  restore(restored, whole.state(), save(whole));
  EXPECT_EQ(unbalanced_end(restored), whole.message());
}

}  // namespace
}  // namespace dda
