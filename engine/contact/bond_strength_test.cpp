#include "engine/contact/bond_strength.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace dda
