// Dry joints under the projected law between blocks that move and turn as a whole: the same as in small kinematics as
// long as motions are small, the same whichever way the scene is turned, and contacts of vertices when blocks part.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/geometry/rotation.h"
#include "engine/model/motion.h"
#include "engine/simulation/memory_test_support.h"
#include "engine/simulation/projected_models.h"

namespace dda {
namespace {

std::size_t stretches(const Simulation& simulation) {
  return static_cast<std::size_t>(
      std::ranges::count(simulation.contacts().elements.own(), InterfaceLaw::projected, &InterfaceElement::law));
}

// A wall in running bond on a floor that is shaken so hard that bricks slide and lift off.
Model shaken_wall(Kinematics kinematics, double amplitude, int steps) {
  return wall_on_shaken_floor(amplitude * Vec2(3, 4),
                              stage_of(generalized_alpha_integrator(0), 2e-4, steps, kinematics));
}

double largest_difference(const Simulation& one, const Simulation& other) {
  double largest = 0;
  double difference = 0;
  for (std::size_t i = 0; i < one.state().velocity.size(); ++i) {
    largest = std::max(largest, one.state().velocity[i].head<2>().norm());
    difference = std::max(difference, (one.state().velocity[i] - other.state().velocity[i]).head<2>().norm());
  }
  return difference / largest;
}

// Slip and opening of hundredths of a millimetre: what finite kinematics know more is of that over a metre.
TEST(ProjectedMotion, OfSmallAmplitudeIsThatOfSmallKinematics) {
  Simulation small = simulation_of(shaken_wall(Kinematics::small, 1e-5, 200));
  Simulation finite = simulation_of(shaken_wall(Kinematics::finite, 1e-5, 200));
  run(small, 200);
  run(finite, 200);
  EXPECT_EQ(stretches(finite), stretches(small));
  EXPECT_LT(largest_difference(small, finite), 1e-2);
}

TEST(ProjectedMotion, LedgerBalancesWhileBlocksPart) {
  Simulation simulation = simulation_of(shaken_wall(Kinematics::finite, 1e-4, 1000));
  const std::size_t at_first = stretches(simulation);
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    ASSERT_EQ(simulation.step(), Status::ok) << "step " << i << ": " << simulation.message();
    worst = std::max(worst, std::abs(simulation.energy().relative_residual()));
  }
  EXPECT_LT(worst, 1e-9);
  EXPECT_LT(stretches(simulation), at_first);
  EXPECT_GT(stretches(simulation), 0U);
  EXPECT_GT(simulation.energy().friction, 0);
  EXPECT_GT(simulation.energy().numerical, -1e-3 * simulation.energy().scale());
}

Model turned(Model model, double angle) {
  const Mat2 turn = rotation(angle);
  for (Block& block : model.blocks)
    for (Vec2& vertex : block.shape.outer) vertex = turn * vertex;
  for (HeldBlock& held : model.held_blocks) held.amplitude = turn * held.amplitude;
  model.gravity = turn * model.gravity;
  return model;
}

TEST(ProjectedMotion, IsTheSameWhicheverWayTheSceneIsTurned) {
  const Model drawn = shaken_wall(Kinematics::finite, 1e-3, 300);
  Simulation upright = simulation_of(drawn);
  Simulation leaning = simulation_of(turned(drawn, 2.1));
  run(upright, 300);
  run(leaning, 300);
  const Mat2 turn = rotation(2.1);
  double largest = 0;
  double difference = 0;
  for (std::size_t i = 0; i < upright.state().velocity.size(); ++i) {
    const Vec2 expected = turn * upright.state().velocity[i].head<2>();
    largest = std::max(largest, expected.norm());
    difference = std::max(difference, (expected - leaning.state().velocity[i].head<2>()).norm());
  }
  EXPECT_LT(difference, 1e-6 * largest);  // round-off, which sliding contacts let grow
}

// A block under the pull of gravity down a slope, far beyond where its stretch ends.
Model block_on_slope(double degrees, double friction, int steps) {
  const double angle = degrees * std::numbers::pi / 180;
  Model model;
  model.materials = {rock()};
  model.joints = {dry_projected(friction)};
  model.blocks = {rectangle("slope", -2, -1, 12, 1), rectangle("block", 0, 0, 1, 0.5)};
  model.held_blocks.resize(1);
  model.gravity = 10 * Vec2(std::sin(angle), -std::cos(angle));
  model.stages = {stage_of(static_integrator(), 1, 10, Kinematics::finite)};
  model.stages[0].unlimited_strength = true;
  model.stages.push_back(stage_of(generalized_alpha_integrator(0), 1e-3, steps, Kinematics::finite));
  model.stages[1].name = "slide";
  return model;
}

TEST(ProjectedMotion, SlidesDownASlopeThroughTheEndOfItsStretch) {
  Simulation simulation = simulation_of(block_on_slope(40, 0.5, 600));
  run(simulation, 10);
  EXPECT_EQ(stretches(simulation), 1U);
  const double acceleration =
      10 * (std::sin(40 * std::numbers::pi / 180) - 0.5 * std::cos(40 * std::numbers::pi / 180));
  double worst = 0;
  for (int i = 1; i <= 600; ++i) {
    ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
    const double expected = acceleration * i * 1e-3;
    worst = std::max(worst, std::abs(simulation.state().velocity[1](0) - expected));
  }
  EXPECT_EQ(stretches(simulation), 0U);
  EXPECT_LT(worst, 2e-3 * acceleration * 0.6);
  EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
}

TEST(ProjectedMotion, GoesOnToTheSameBitsFromASnapshot) {
  const auto make = [] { return simulation_of(shaken_wall(Kinematics::finite, 1e-4, 600)); };
  Simulation whole = make();
  run(whole, 300);
  const std::size_t in_between = stretches(whole);
  const State state = whole.state();
  const std::vector<std::byte> saved = save(whole);
  run(whole, 300);
  EXPECT_LT(stretches(whole), in_between);
  Simulation again = make();
  again.restore(state, saved);
  run(again, 300);
  EXPECT_EQ(memory_of(again), memory_of(whole));
}

// In either direction: gaps of small kinematics are of first order in the turns of blocks, and what stretches take off
// their blocks has a direction.
TEST(ProjectedMotion, LedgerBalancesWhereKinematicsChange) {
  for (const Kinematics first : {Kinematics::small, Kinematics::finite}) {
    const Kinematics second = first == Kinematics::small ? Kinematics::finite : Kinematics::small;
    Model model = shaken_wall(first, 3e-5, 200);
    model.stages.push_back(stage_of(generalized_alpha_integrator(0), 2e-4, 200, second));
    model.stages[1].name = "then";
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, 200);
    const double before = simulation.energy().numerical;
    run(simulation, 1);
    EXPECT_LT(std::abs(simulation.energy().numerical - before), 1e-3 * simulation.energy().scale());
    run(simulation, 199);
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
  }
}

// A staple stands on one leg beside its middle; the other one hangs a millimetre above the floor, and tips on to it.
TEST(ProjectedMotion, BlocksWithCornersThatPointInwardsTouchElsewhere) {
  Block staple;
  staple.name = "staple";
  staple.shape.outer = {{0, 0}, {0.3, 0}, {0.3, 0.5}, {1.7, 0.5}, {1.7, 1e-3}, {2, 1e-3}, {2, 1}, {0, 1}};
  Model model = on_floor(staple, 0.8, stage_of(generalized_alpha_integrator(0), 1e-3, 500, Kinematics::finite));
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 500);
  const double tip = point_displacement(simulation.model(), simulation.state(), 1, {2, 1e-3}).y();
  EXPECT_NEAR(tip, -1e-3, 2e-5);
}

// Pressed beyond the points of its law, by a weight whose middle is near an end of the joint.
TEST(ProjectedMotion, SticksUnderUnlimitedStrengthWhereverItIsPressed) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    Block leaning;
    leaning.name = "leaning";
    leaning.shape.outer = {{0, 0}, {1, 0}, {1.85, 2}, {0.85, 2}};
    Model model = on_floor(leaning, 0.8, stage_of(static_integrator(), 1, 20, kinematics));
    model.point_loads = {{1, {0.925, 1}, {2e3, 0}, Constant{}}};
    model.stages[0].unlimited_strength = true;
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, 20);
    EXPECT_LT(std::abs(point_displacement(simulation.model(), simulation.state(), 1, {1, 0}).x()), 1e-4);
  }
}

// A wall that was thrown about and is to settle: from the first step that does not on, its contacts are cushioned.
TEST(ProjectedMotion, SettlesToTheSameBitsFromASnapshot) {
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::projected}) {
    const auto make = [&] {
      Model model = shaken_wall(Kinematics::finite, 1e-4, 250);
      model.joints[0].law = law;
      Stage rest;
      rest.name = "rest";
      rest.integrator = static_integrator();
      rest.equilibrium = 1e-9;
      model.stages.push_back(rest);
      return simulation_of(std::move(model));
    };
    Simulation whole = make();
    run(whole, 250);
    for (int step = 0; step < 12 && !whole.finished(); ++step) {
      Simulation again = make();
      again.restore(whole.state(), save(whole));
      ASSERT_EQ(whole.step(), Status::ok) << whole.message();
      ASSERT_EQ(again.step(), Status::ok) << again.message();
      ASSERT_EQ(memory_of(again), memory_of(whole)) << "step " << step;
    }
  }
}

}  // namespace
}  // namespace dda
