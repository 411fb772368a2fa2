#include "engine/contact/bond_strength.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "engine/contact/open_close.h"

namespace dda {
namespace {

using Ends = std::array<bool, 2>;

// Half of the length carries 10 in tension and 6 in shear without friction.
const EndStrength glued{.tension = 10, .cohesion = 6, .friction = 0.5};

InterfaceSprings stretch_with(double lever) {
  InterfaceSprings springs;
  springs.law = InterfaceLaw::projected;
  springs.length = 2;
  springs.lever = lever;
  springs.stiffness.setConstant(100);
  return springs;
}

// What breaks of a bond, or of the rest of one, under these forces.
Ends broken_by(const InterfaceSprings& springs, const Vec4& force, const Ends& before = {false, false}) {
  InterfaceTrial trial;
  trial.force = force;
  trial.broken = before;
  break_ends(springs, glued, trial);
  return trial.broken;
}

bool breaks(const Vec4& force, double lever = 1 / 3.0) {
  const Ends broken = broken_by(stretch_with(lever), force);
  EXPECT_EQ(broken[0], broken[1]) << "as a whole";
  return broken[0];
}

// Forces of the points with a given sum and moment about the middle: the moment is their difference times the lever.
Vec4 bent(double normal, double moment, double lever) {
  const double difference = 2 * moment / (lever * 2);
  return {(normal - difference) / 2, 0, (normal + difference) / 2, 0};
}

// N/l + 6 M/l^2 = 10, wherever the points lie.
TEST(BondStrength, AStretchTearsAtItsEdgeWhereverItsPointsLie) {
  for (const double lever : {0.2, 1 / 3.0, 0.57}) {
    for (const double side : {-1.0, 1.0}) {
      EXPECT_FALSE(breaks(bent(8, 0.999 * side * 4, lever), lever)) << lever;
      EXPECT_TRUE(breaks(bent(8, 1.001 * side * 4, lever), lever)) << lever;
    }
  }
}

TEST(BondStrength, AMomentLeavesTheShearStrengthOfAStretch) {
  for (const double moment : {0.0, 3.0, -3.0}) {
    const Vec4 pressed = bent(-8, moment, 1 / 3.0);
    EXPECT_FALSE(breaks(pressed + Vec4(0, 0.999 * 8, 0, 0.999 * 8)));
    EXPECT_TRUE(breaks(pressed + Vec4(0, 1.001 * 8, 0, 1.001 * 8)));
    EXPECT_TRUE(breaks(pressed - Vec4(0, 1.001 * 8, 0, 1.001 * 8)));
  }
}

// Shared unevenly it is the same shear. Opposite shear of both points counts as forces at the edges with its moment.
TEST(BondStrength, ShearOfAStretchIsJudgedByWhatHasItsResultants) {
  EXPECT_FALSE(breaks({0, 18, 0, -6.1}));
  EXPECT_TRUE(breaks({0, 18, 0, -5.9}));
  EXPECT_FALSE(breaks({0, 17.9, 0, -17.9}));
  EXPECT_TRUE(breaks({0, 18.1, 0, -18.1}));
}

// What opposite shear is beyond the strength is strain: a stretch that presses keeps its strength, one that does not
// has failed.
TEST(BondStrength, AStretchThatPressesYieldsToOppositeShear) {
  for (const double side : {1.0, -1.0}) {
    const auto residual_by = [&](const Vec4& force) {
      InterfaceTrial trial;
      trial.force = force;
      break_ends(stretch_with(1 / 3.0), glued, trial);
      EXPECT_EQ(trial.broken, (Ends{true, true}));
      return trial.residual;
    };
    EXPECT_EQ(residual_by({-4, side * 25, -4, -side * 25}), (Ends{false, false}));
    EXPECT_EQ(residual_by({-4, side * 9, -4, side * 9}), (Ends{true, true})) << "sheared off";
    EXPECT_EQ(residual_by({4, side * 25, 4, -side * 25}), (Ends{true, true})) << "it does not press";
  }
}

TEST(BondStrength, EndsOfOtherLawsBreakByThemselves) {
  InterfaceSprings springs = stretch_with(1);
  springs.law = InterfaceLaw::classical;
  EXPECT_EQ(broken_by(springs, {10.1, 0, 9.9, 0}), (Ends{true, false}));
  EXPECT_EQ(broken_by(springs, {0, 5.9, 0, -6.1}), (Ends{false, true}));
  EXPECT_EQ(broken_by(springs, Vec4::Zero(), {true, false}), (Ends{true, false}));
}

// Both ends have failed at once, whichever point was beyond its strength.
TEST(BondStrength, ABrokenStretchHasItsResidualStrengthAtBothEnds) {
  const EndStrength weakening{.tension = 10, .cohesion = 6, .friction = 0.5, .friction_drop = 0.3};
  for (const double side : {-1.0, 1.0}) {
    InterfaceTrial trial;
    trial.force = bent(8, 5 * side, 1 / 3.0);
    EXPECT_TRUE(break_ends(stretch_with(1 / 3.0), weakening, trial));
    EXPECT_EQ(trial.residual, (Ends{true, true}));
    EXPECT_FALSE(break_ends(stretch_with(1 / 3.0), weakening, trial));
  }
}

// Friction 0.5 before and 0.2 after, no tensile strength.
const EndStrength cohesive{.cohesion = 6, .friction = 0.5, .friction_drop = 0.3};

// Taken to these normal gaps, where it sticks.
InterfaceTrial stuck_at(const Vec2& gaps) {
  InterfaceTrial trial = start_trial(stretch_with(1 / 3.0), cohesive, {});
  trial.gap << gaps(0), 0, gaps(1), 0;
  respond_with_friction(stretch_with(1 / 3.0), cohesive, trial);
  return trial;
}

void follow(const Vec2& gaps, InterfaceTrial& trial) {
  trial.gap << gaps(0), trial.gap(1), gaps(1), trial.gap(3);
  respond_with_friction(stretch_with(1 / 3.0), cohesive, trial);
}

double capacity_of_both(const InterfaceTrial& trial) { return trial.capacity[0] + trial.capacity[1]; }

// What is closed at gaps of a mean of 0 and a turn is (1 - 0)/(1 + root of 1/3).
TEST(BondStrength, WhatIsLeftOfATornStretchHasItsCohesion) {
  const double closed = 1 / (1 + std::sqrt(1 / 3.0));
  InterfaceTrial trial = stuck_at({0.05, -0.1});
  EXPECT_TRUE(break_ends(stretch_with(1 / 3.0), cohesive, trial));
  EXPECT_EQ(trial.broken, (Ends{true, true}));
  EXPECT_EQ(trial.residual, (Ends{false, false}));
  follow({0.1, -0.1}, trial);
  EXPECT_EQ(trial.capacity[0], 0) << "the far point does not press";
  EXPECT_NEAR(capacity_of_both(trial), 12 * closed - 0.5 * (trial.force(0) + trial.force(2)), 1e-12);
  EXPECT_FALSE(break_ends(stretch_with(1 / 3.0), cohesive, trial)) << "the near point sticks";
}

double left_closed(InterfaceState state) {
  state.force << -10, 0, -10, 0;
  const auto capacity = [&](int end) { return stretch_capacity(stretch_with(1 / 3.0), cohesive, state, end); };
  return capacity(0) + capacity(1) - 0.5 * 20;
}

// Either end in turn, by forces of the points of which the far one pulls by a third of what the near one presses: they
// press together at 2/3 of half the length from the middle, which leaves half of it closed.
TEST(BondStrength, WhatHasGapedHasNoCohesionWhenItClosesAgain) {
  const InterfaceSprings springs = stretch_with(1 / 3.0);
  InterfaceState state;
  state.broken = {true, true};
  state.force << 10, 0, -30, 0;
  note_torn(springs, state);
  EXPECT_NEAR(state.torn[0], 0.5, 1e-15);
  EXPECT_EQ(state.torn[1], 0);
  EXPECT_NEAR(left_closed(state), 12 * 0.5, 1e-14);
  state.force << -27, 0, 3, 0;
  note_torn(springs, state);
  EXPECT_NEAR(state.torn[1], 0.125, 1e-15);
  EXPECT_NEAR(left_closed(state), 12 * 0.375, 1e-14);
  const InterfaceState before = state;
  state.force << -10, 0, -10, 0;
  note_torn(springs, state);
  EXPECT_EQ(state.torn, before.torn);
}

// Neither point loses its share at once when the other gapes.
TEST(BondStrength, CapacitiesOfATornStretchFollowItsGapsWithoutAJump) {
  InterfaceTrial trial = stuck_at({0.05, -0.1});
  break_ends(stretch_with(1 / 3.0), cohesive, trial);
  follow({-0.2, -0.1}, trial);
  std::array<double, 2> before = trial.capacity;
  double largest = 0;
  for (int i = 1; i <= 20000; ++i) {
    follow({-0.2 + 0.29 * i / 20000, -0.1}, trial);
    for (const std::size_t end : {0U, 1U}) largest = std::max(largest, std::abs(trial.capacity[end] - before[end]));
    before = trial.capacity;
  }
  EXPECT_LT(largest, 0.01) << "of 6 to 12, in 20,000 steps";
}

TEST(BondStrength, ATornStretchFailsWhenItSlidesOrOpensAsAWhole) {
  const InterfaceSprings springs = stretch_with(1 / 3.0);
  const auto torn = [&] {
    InterfaceTrial trial = stuck_at({0.05, -0.1});
    break_ends(springs, cohesive, trial);
    return trial;
  };
  InterfaceTrial slides = torn();
  slides.gap(1) = slides.gap(3) = 0.3;
  follow({-0.1, -0.1}, slides);
  EXPECT_TRUE(break_ends(springs, cohesive, slides));
  EXPECT_EQ(slides.residual, (Ends{true, true}));
  follow({-0.1, -0.1}, slides);
  EXPECT_NEAR(capacity_of_both(slides), -0.2 * (slides.force(0) + slides.force(2)), 1e-14);
  InterfaceTrial opens = torn();
  follow({0.1, 0.1}, opens);
  EXPECT_TRUE(break_ends(springs, cohesive, opens));
  EXPECT_EQ(opens.residual, (Ends{true, true}));
  InterfaceTrial one_end = torn();
  one_end.gap(1) = 0.3;
  follow({-0.1, -0.1}, one_end);
  EXPECT_FALSE(break_ends(springs, cohesive, one_end)) << "the other end sticks";
  one_end.gap(3) = -0.3;
  follow({-0.1, -0.1}, one_end);
  EXPECT_FALSE(break_ends(springs, cohesive, one_end)) << "both slide against each other";
  one_end.gap(3) = 0.3;
  follow({-0.1, -0.1}, one_end);
  EXPECT_TRUE(break_ends(springs, cohesive, one_end));
}

// It has no bond to lose by opening.
TEST(BondStrength, ADryStretchHasItsPeakFrictionUntilItSlidesAsAWhole) {
  const InterfaceSprings springs = stretch_with(1 / 3.0);
  const EndStrength dry{.friction = 0.5, .friction_drop = 0.3};
  InterfaceState start;
  start.broken = {true, true};
  InterfaceTrial trial = start_trial(springs, dry, start);
  const auto leaves_residual = [&](const Vec4& gap) {
    trial.gap = gap;
    respond_with_friction(springs, dry, trial);
    return break_ends(springs, dry, trial);
  };
  EXPECT_FALSE(leaves_residual({-0.1, 0.3, -0.1, 0})) << "one end sticks";
  EXPECT_FALSE(leaves_residual({-0.1, 0.3, -0.1, -0.3})) << "both slide against each other";
  EXPECT_FALSE(leaves_residual({0.1, 0.3, 0.1, 0.3})) << "it is open";
  EXPECT_TRUE(leaves_residual({-0.1, 0.3, -0.1, 0.3}));
  EXPECT_EQ(trial.residual, (Ends{true, true}));
  EXPECT_FALSE(leaves_residual({-0.1, 0.3, -0.1, 0.3})) << "once";
}

}  // namespace
}  // namespace dda
