// Held blocks that several histories move, and such that go away from what they carry.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/core/error.h"
#include "engine/simulation/free_field_models.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

HeldBlock moved(int block, const Vec2& amplitude, const TimeFunction& history, MotionKind kind) {
  HeldBlock held;
  held.block = block;
  held.amplitude = amplitude;
  held.history = history;
  held.kind = kind;
  return held;
}

// The two components of a record, and how far it carries along besides.
HeldBlock along_x(int block) { return moved(block, {1, 0}, SineCycles{50, 3, 0}, MotionKind::acceleration); }
HeldBlock along_y(int block) { return moved(block, {0, 0.7}, SineCycles{90, 2, 0.01}, MotionKind::acceleration); }
HeldBlock carrying(int block) {
  return moved(block, {2e-3, 1e-3}, PiecewiseLinear{{0, 0.07}, {0, 1}}, MotionKind::displacement);
}

Model bar_moved_by(std::vector<HeldBlock> motions, const JointMaterial& joint, Kinematics kinematics) {
  Model model = bar_of(3, joint);
  model.held_blocks = std::move(motions);
  model.stages = {stage_of(generalized_alpha_integrator(0.8), 1e-3, 70, kinematics)};
  return model;
}

// Each history is exact by itself (HeldBlocks.FollowTheRecordExactly); all of them move the block by their sum.
TEST(SummedMotions, MoveABlockByAllOfItsHistories) {
  const std::vector<HeldBlock> motions = {along_x(0), along_y(0), carrying(0)};
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    Simulation simulation = simulation_of(bar_moved_by(motions, strong(InterfaceLaw::consistent), kinematics));
    while (!simulation.finished()) {
      ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
      Vec2 way = Vec2::Zero(), speed = Vec2::Zero();
      for (const HeldBlock& held : motions) {
        const MotionFactors factors = motion_at(held.kind, held.history, simulation.state().time);
        way += factors.displacement * held.amplitude;
        speed += factors.velocity * held.amplitude;
      }
      EXPECT_LT((simulation.state().displacement[0].head<2>() - way).norm(), 1e-16);  // of sums below 1e-2 m
      EXPECT_LT((simulation.state().velocity[0].head<2>() - speed).norm(), 1e-15);
    }
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-11);
  }
}

// In linear steps what all histories do together is the sum of what each does alone.
TEST(SummedMotions, SuperposeInTheRockThatTheyShake) {
  const JointMaterial joint = bond(InterfaceLaw::consistent);
  const auto last_block = [&](const std::vector<HeldBlock>& motions) {
    Simulation simulation = simulation_of(bar_moved_by(motions, joint, Kinematics::small));
    run(simulation, 70);
    return simulation.state().displacement[2];
  };
  const Vec6 sum = last_block({along_x(0)}) + last_block({along_y(0)}) + last_block({carrying(0)});
  const Vec6 together = last_block({along_x(0), along_y(0), carrying(0)});
  EXPECT_GT(sum.norm(), 1e-3);
  EXPECT_LT((together - sum).norm(), 1e-11 * sum.norm());  // round-off of some 70 steps
}

// Columns beside a free field stand on a base of their own, which all histories of the base move.
TEST(SummedMotions, MoveTheColumnsOfFreeFields) {
  Model model = free_field::shaken_grid(bond(InterfaceLaw::classical));
  const HeldBlock both = model.held_blocks[0];
  model.held_blocks = {both, both};
  model.held_blocks[0].amplitude.y() = 0;
  model.held_blocks[1].amplitude.x() = 0;
  model.held_blocks[1].history = SineCycles{140, 1, 0};
  Simulation simulation = simulation_of(std::move(model));
  EXPECT_LT(free_field::difference_from_columns(simulation, 200), 1e-8);  // round-off, as with one history
}

TEST(SummedMotions, AreRefusedWhereTheyContradict) {
  const JointMaterial joint = bond(InterfaceLaw::consistent);
  HeldBlock still;
  HeldBlock turned;
  turned.turn = 0.1;
  EXPECT_THROW(simulation_of(bar_moved_by({along_x(0), still}, joint, Kinematics::finite)), InputError);
  EXPECT_THROW(simulation_of(bar_moved_by({turned, turned}, joint, Kinematics::finite)), InputError);
  EXPECT_THROW(simulation_of(bar_moved_by({along_x(0), along_x(1), along_y(0)}, joint, Kinematics::finite)),
               InputError);
  EXPECT_NO_THROW(simulation_of(bar_moved_by({along_x(0), turned, along_x(1)}, joint, Kinematics::finite)));
}

// A stone lies across two held blocks, of which the right one begins to sink at a speed, as the stage in motion does.
// Its contact lets go of the stone after a hundredth of a micron, but was taken to work with half of its force over all
// of the way of the first step: 98 % of the largest energy seemed to come from nowhere, at any dt.
TEST(HeldBlocksGoingAway, GainNothing) {
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::projected}) {
    for (const double dt : {1e-3, 1e-4}) {
      Model model;
      model.materials = {{"rock", 2500, 2e10, 0.2, PlaneState::stress}};
      model.joints = {{.name = "dry", .law = law, .friction_angle = 0.6}};
      model.blocks = {rectangle("left", -1, -1, 1.35, 1), rectangle("right", 0.35, -1, 1.65, 1),
                      rectangle("stone", 0, 0, 0.59, 0.21)};
      model.held_blocks.resize(2);
      model.held_blocks[1].block = 1;
      model.held_blocks[1].amplitude = {0, -0.02};
      model.held_blocks[1].history = PiecewiseLinear{{0, 1}, {0, 1}};
      model.gravity = {0, -9.81};
      Stage rest;
      rest.integrator = static_integrator();
      rest.equilibrium = 1e-9;
      Stage sinks;
      sinks.integrator = generalized_alpha_integrator(0);
      sinks.dt = dt;
      sinks.duration = 0.2;
      model.stages = {rest, sinks};
      Simulation simulation = simulation_of(model);
      while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
      EXPECT_LT(simulation.energy().gain(), 2e-3) << dt;  // measured 1.1e-3; 0.89 and more before
      EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9) << dt;
      EXPECT_NEAR(simulation.state().displacement[2](1), 0, 1e-6) << dt;
    }
  }
}

}  // namespace
}  // namespace dda
