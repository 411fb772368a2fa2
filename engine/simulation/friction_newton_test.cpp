// Newton's method with friction in it: how many passes it takes, and that it ends where the sure way ends.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

JointMaterial dry(double friction_angle) {
  JointMaterial joint = bond(InterfaceLaw::classical);
  joint.bonded = false;
  joint.friction_angle = friction_angle;
  return joint;
}

// A block slides at a steady rate of growth: friction follows the normal force within the one pass that it takes.
TEST(FrictionNewton, TakesOnePassForABlockThatSlides) {
  Model model = model_of({{box_ring(-5, -1, 5, 0), {}}, {box_ring(0, 0, 1, 0.5), {}}});
  model.joints = {dry(0.3)};
  model.gravity = {5, -8.5};
  model.held_blocks.emplace_back();
  model.blocks[1].initial_velocity = {1, 0};
  model.stages = {stage_of(thesis_integrator(), 1e-4, 300, Kinematics::small)};
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 200);
  const std::int64_t before = simulation.counters().open_close_iterations;
  run(simulation, 100);
  EXPECT_LE(simulation.counters().open_close_iterations - before, 110);
}

// Balances to 1e-10 of the largest contact force in each of a hundred steps, of which 1e-8 are the sum.
void expect_same_motion(const Simulation& one, const Simulation& other) {
  double difference = 0, largest = 0;
  for (std::size_t i = 0; i < one.state().displacement.size(); ++i) {
    difference = std::max(difference, (one.state().displacement[i] - other.state().displacement[i]).norm());
    largest = std::max(largest, one.state().displacement[i].norm());
  }
  EXPECT_LT(difference, 1e-7 * largest);
}

Model falling_wall(double friction_angle, SolverRequest solver) {
  Model model = grid_of(6, dry(friction_angle), Pattern::running_bond);
  model.gravity = {1, -9.81};
  model.blocks.emplace_back().shape.outer = box_ring(-1, -1, 7, 0);
  model.held_blocks.emplace_back().block = static_cast<int>(model.blocks.size()) - 1;
  model.stages = {stage_of(thesis_integrator(), 1e-3, 100, Kinematics::finite)};
  model.stages[0].solver = solver;
  return model;
}

// Bricks that gravity is switched on for at once: hundreds of contacts open, close and slide in every step.
TEST(FrictionNewton, EndsInTheSameStateWithEverySolver) {
  for (const double angle : {0.0, 0.2, 0.6}) {
    SCOPED_TRACE(angle);
    Simulation one = simulation_of(falling_wall(angle, SolverRequest::cholesky));
    Simulation other = simulation_of(falling_wall(angle, SolverRequest::pcg));
    run(one, 100);
    run(other, 100);
    EXPECT_GT(one.counters().contact_state_changes, 1000);
    EXPECT_LT(static_cast<double>(one.counters().open_close_iterations), 1000);
    expect_same_motion(one, other);
    EXPECT_LT(std::abs(one.energy().relative_residual()), 1e-9);
    EXPECT_LT(std::abs(other.energy().relative_residual()), 1e-9);
  }
}

// A long course of bricks that lie still, and a pile that slides on one end of it.
Simulation course_with_a_pile(int bricks, SolverRequest solver) {
  Model model = model_of({{box_ring(-1, -1, bricks + 1, 0), {}}});
  model.held_blocks.emplace_back();
  for (int i = 0; i < bricks; ++i) model.blocks.emplace_back().shape.outer = box_ring(i, 0, i + 1, 0.6);
  for (int row = 1; row < 5; ++row)
    for (int i = 0; i < 5; ++i) {
      Block& brick = model.blocks.emplace_back();
      brick.shape.outer = box_ring(i + 0.5 * (row % 2), 0.6 * row, i + 1 + 0.5 * (row % 2), 0.6 * (row + 1));
      brick.initial_velocity = {0.3 * row, 0};
    }
  model.joints = {dry(0.5)};
  model.gravity = {0, -9.81};
  model.stages = {stage_of(thesis_integrator(), 1e-3, 60, Kinematics::finite)};
  model.stages[0].solver = solver;
  return simulation_of(std::move(model));
}

// Most passes have to do with the pile alone, and leave the same as passes over all.
TEST(FrictionNewton, MovesThePartThatIsOutOfBalance) {
  Simulation whole = course_with_a_pile(120, SolverRequest::dense);
  Simulation in_parts = course_with_a_pile(120, SolverRequest::pcg);
  run(whole, 60);
  run(in_parts, 60);
  EXPECT_EQ(whole.counters().local_passes, 0);
  EXPECT_GT(in_parts.counters().local_passes, 60);
  expect_same_motion(whole, in_parts);
  EXPECT_LT(std::abs(in_parts.energy().relative_residual()), 1e-9);
}

// So they do beside complete factors, whose parts begin with the blocks that are worst, where there are enough blocks.
TEST(FrictionNewton, MovesThePartThatIsWorstBesideACompleteFactor) {
  Simulation small = course_with_a_pile(120, SolverRequest::cholesky);
  run(small, 5);
  EXPECT_EQ(small.counters().local_passes, 0);
  Simulation one = course_with_a_pile(400, SolverRequest::cholesky);
  Simulation other = course_with_a_pile(400, SolverRequest::pcg);
  run(one, 60);
  run(other, 60);
  EXPECT_GT(one.counters().local_passes, 60);
  expect_same_motion(one, other);
  EXPECT_LT(std::abs(one.energy().relative_residual()), 1e-9);
}

// Three beds of blocks between abutments, thrust up while joints stick. Where friction is to hold them afterwards, beds
// that slide on each other and joints that open go hand in hand; a fixed point over capacities creeps there.
TEST(FrictionNewton, SettlesBedsThatSlideOnEachOther) {
  for (const double degrees : {31.0, 45.0, 60.0}) {
    Model model = model_of({{box_ring(-2, -0.5, 0, 2), {}}, {box_ring(7, -0.5, 9, 2), {}}});
    for (int block : {0, 1}) model.held_blocks.emplace_back().block = block;
    for (int bed = 0; bed < 3; ++bed)
      for (int column = 0; column < 7; ++column)
        model.blocks.emplace_back().shape.outer = box_ring(column, 0.5 * bed, column + 1, 0.5 * (bed + 1));
    model.materials[0].young = 20e9;
    model.joints = {dry(degrees * std::numbers::pi / 180)};
    model.gravity = {0, -9.81};
    Stage thrust = stage_of(static_integrator(), 0.1, 20, Kinematics::finite);
    thrust.unlimited_strength = true;
    Stage stand = stage_of(static_integrator(), 0.1, 30, Kinematics::finite);
    stand.equilibrium = 1e-9;
    model.stages = {thrust, stand};
    Simulation simulation = simulation_of(std::move(model));
    while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << degrees << ": " << simulation.message();
    EXPECT_LT(simulation.results().out_of_balance[1], 1e-9);
    // It stands: 7.3e-3 m, of which thrust up without friction at ends that only touch makes half.
    for (const Vec6& u : simulation.state().displacement) EXPECT_LT(u.norm(), 1e-2);
  }
}

}  // namespace
}  // namespace dda
