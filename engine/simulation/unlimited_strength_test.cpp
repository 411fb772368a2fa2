// Stages in which joints stick whatever they carry, while they are closed.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "engine/geometry/rotation.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr double standard_gravity = 9.81;  // m/s2

Stage stuck() {
  Stage stage = stage_of(static_integrator(), 0, 0, Kinematics::finite);
  stage.equilibrium = 1e-9;
  stage.unlimited_strength = true;
  return stage;
}

Block turned(Block block, double angle) {
  for (Vec2& vertex : block.shape.outer) vertex = rotation(angle) * vertex;
  return block;
}

// What contacts carry along themselves and across, N per m of thickness.
Vec2 carried(const Simulation& simulation) {
  Vec2 sum = Vec2::Zero();
  for (const InterfaceState& state : simulation.contacts().states)
    for (const Eigen::Index end : {0, 2}) sum += Vec2(-state.force(end), std::abs(state.force(end + 1)));
  return sum;
}

Model block_on_slope(double slope, double friction_angle) {
  Model model = bar_of(0, JointMaterial{});
  model.joints[0].law = InterfaceLaw::classical;
  model.joints[0].friction_angle = friction_angle;
  model.blocks = {turned(rectangle("floor", -5, -1, 10, 1), slope), turned(rectangle("block", -1, 0, 2, 1), slope)};
  model.held_blocks.emplace_back().block = 0;
  model.gravity = {0, -standard_gravity};
  model.stages = {stuck()};
  return model;
}

// Steeper than its friction: what has settled is shown before what is too much for the strength slides, and excess
// shear, forces and frames are of one moment. It showed shear at the strength, and reactions that did not carry the
// weight.
TEST(UnlimitedStrength, WhatHasSettledIsInEquilibriumAtTheEndOfTheStage) {
  std::mt19937 random(3);
  const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  for (int scene = 0; scene < 20; ++scene) {
    const double slope = number(0.2, 0.9);
    const double friction_angle = number(0, 0.9) * slope;
    Simulation simulation = simulation_of(block_on_slope(slope, friction_angle));
    const double weight = simulation.model().mass_of(1) * standard_gravity;
    Vec2 at_end = Vec2::Zero();
    simulation.watch().at_end = [&] { at_end = carried(simulation); };
    while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
    const double allowed = 1e-6 * weight;  // of the strains that the block settles by, which turn its faces
    EXPECT_NEAR(at_end(0), weight * std::cos(slope), allowed) << scene;
    EXPECT_NEAR(at_end(1), weight * std::sin(slope), allowed) << scene;
    // Each end keeps what its own pressure allows.
    EXPECT_LE(carried(simulation)(1), weight * std::cos(slope) * std::tan(friction_angle) + allowed) << "let go";
  }
}

// Cubes in a slot that they exactly touch, the whole of it turned.
Model cubes_in_slot(int cubes, double angle) {
  Model model = bar_of(0, JointMaterial{});
  model.joints[0].law = InterfaceLaw::classical;
  model.joints[0].friction_angle = 0.5;
  model.blocks = {rectangle("floor", -2, -1, 5, 1), rectangle("left", -1, 0, 1, cubes),
                  rectangle("right", 1, 0, 1, cubes)};
  for (int held = 0; held < 3; ++held) model.held_blocks.emplace_back().block = held;
  for (int i = 0; i < cubes; ++i) model.blocks.push_back(rectangle("", 0, i, 1, 1));
  for (Block& block : model.blocks) block = turned(std::move(block), angle);
  model.gravity = rotation(angle) * Vec2(0, -standard_gravity);
  model.stages = {stuck()};
  return model;
}

// Gaps of blocks that are drawn against each other are round-off, of either sign. They began open or closed by it, and
// the top cube sank up to 23 times as far at one angle as at another.
TEST(UnlimitedStrength, WhatJustTouchesHoldsWhicheverWayTheSceneIsTurned) {
  std::mt19937 random(5);
  for (const int cubes : {2, 3, 4, 6}) {
    const auto sunk = [&](double angle) -> Vec2 {
      Simulation simulation = simulation_of(cubes_in_slot(cubes, angle));
      while (!simulation.finished()) EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
      return rotation(-angle) * simulation.state().displacement.back().head<2>();
    };
    const Vec2 upright = sunk(0);
    EXPECT_LT(upright.y(), 0);
    for (int i = 0; i < 8; ++i) {
      const double angle = std::uniform_real_distribution(-3.0, 3.0)(random);
      EXPECT_LT((sunk(angle) - upright).norm(), 1e-6 * upright.norm()) << cubes << " cubes turned by " << angle;
    }
  }
}

// A block of 1 m below a held roof, with nothing but a dry joint between them.
Model hung(InterfaceLaw law, Stage stage) {
  Model model;
  model.gravity = {0, -standard_gravity};
  model.materials = {{"rock", 2600, 50e9, 0.2, PlaneState::stress}};
  JointMaterial joint;
  joint.law = law;
  joint.friction_angle = 0.7;
  model.joints = {joint};
  model.blocks = {rectangle("roof", -1, 1, 3, 1), rectangle("block", 0, 0, 1, 1)};
  model.held_blocks = {{.block = 0, .history = Constant{}}};
  stage.unlimited_strength = true;
  model.stages = {std::move(stage)};
  return model;
}

// Where kinematics are small dry joints of these laws carried it, for as long as their strength was unlimited.
TEST(UnlimitedStrength, DryJointsDoNotHoldWhatHangs) {
  constexpr double dt = 1e-3;
  constexpr int steps = 100;
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::consistent, InterfaceLaw::projected})
    for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
      Simulation simulation =
          simulation_of(hung(law, stage_of(generalized_alpha_integrator(0), dt, steps, kinematics)));
      while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
      const double fallen = standard_gravity * std::pow(dt * steps, 2) / 2;
      EXPECT_NEAR(simulation.state().displacement[1].y(), -fallen, 0.03 * fallen)
          << static_cast<int>(law) << ' ' << static_cast<int>(kinematics);
    }
}

TEST(UnlimitedStrength, NorDoTheyInStaticStages) {
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::consistent, InterfaceLaw::projected}) {
    Stage stage = settling_stage(1e-9);
    stage.kinematics = Kinematics::small;
    Simulation simulation = simulation_of(hung(law, stage));
    Status status = Status::ok;
    while (status == Status::ok && !simulation.finished()) status = simulation.step();
    EXPECT_EQ(status, Status::not_in_equilibrium) << static_cast<int>(law);
  }
}

}  // namespace
}  // namespace dda
