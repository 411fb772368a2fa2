// The bed against the sum of its springs, taken one by one.
#include "engine/contact/no_tension_bed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace dda {
namespace {

constexpr double stiffness = 3;  // of each point while closed

struct Forces {
  double normal = 0, moment = 0;  // conjugate to the mean gap and to half of the difference of the ends
};

// Springs that only press along the stretch, place -1 to 1, of a bed that is pressed by `mean` and turned by `turn`.
Forces sum_of_springs(double bed_stiffness, double mean, double turn) {
  constexpr int springs = 20000;
  Forces sum;
  for (int i = 0; i < springs; ++i) {
    const double place = (2 * i + 1.0) / springs - 1;
    const double force = bed_stiffness / springs * std::min(0.0, mean + place * turn);
    sum.normal += force;
    sum.moment += place * force;
  }
  return sum;
}

// The gap of the law is that of the bed less what the blocks' strains have of its compliance already: bisection for
// the gap of the bed.
Forces forces_at(double lever, double mean, double turn) {
  const double whole = 2 * stiffness;
  const double bed = 3 * lever * lever * whole;
  const double excess = 1 / bed - 1 / whole;
  double low = -100;
  double high = 100;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (middle - excess * sum_of_springs(bed, middle, turn).normal < mean ? low : high) = middle;
  }
  return sum_of_springs(bed, (low + high) / 2, turn);
}

Vec2 gaps_at(double lever, double mean, double turn) { return {mean - lever * turn, mean + lever * turn}; }

constexpr std::array levers = {0.3, 0.3227, 1.0 / 3, 0.5};
constexpr std::array means = {-2.0, -1.01, -0.6, -0.35, -0.2, 0.0, 0.3, 0.8, 0.99, 1.2};

TEST(NoTensionBed, AnswersAsSpringsThatOnlyPress) {
  for (const double lever : levers) {
    for (const double mean : means) {
      for (const double turn : {1.0, -1.0}) {
        const Forces expected = forces_at(lever, mean, turn);
        const Vec2 force = press_bed(stiffness, lever, gaps_at(lever, mean, turn)).force;
        // 20,000 springs miss the square of the share of one, and the one in which the joint begins to gape.
        EXPECT_NEAR(force.sum(), expected.normal, 1e-7) << lever << " " << mean;
        EXPECT_NEAR(lever * (force(1) - force(0)), expected.moment, 1e-7) << lever << " " << mean;
      }
    }
  }
}

TEST(NoTensionBed, SlopesAreThoseOfItsForces) {
  constexpr double step = 1e-6;
  for (const double lever : levers) {
    for (const double mean : means) {
      const Vec2 gaps = gaps_at(lever, mean, -1);
      const BedAnswer here = press_bed(stiffness, lever, gaps);
      for (const int point : {0, 1}) {
        const Vec2 aside = step * Vec2::Unit(point);
        const Vec2 slope =
            (press_bed(stiffness, lever, gaps + aside).force - press_bed(stiffness, lever, gaps - aside).force) /
            (2 * step);
        EXPECT_NEAR(slope(point), here.slope(point), 1e-7);
        EXPECT_NEAR(slope(1 - point), here.coupling, 1e-7);
      }
    }
  }
}

// A potential of second degree: half of force times gap is its value, and its slope the force.
TEST(NoTensionBed, StoresHalfOfForceTimesGap) {
  constexpr double step = 1e-6;
  const auto energy = [](const Vec2& gaps) { return gaps.dot(press_bed(stiffness, 0.32, gaps).force) / 2; };
  for (const double mean : means) {
    const Vec2 gaps = gaps_at(0.32, mean, 1);
    const Vec2 force = press_bed(stiffness, 0.32, gaps).force;
    for (const int point : {0, 1}) {
      const Vec2 aside = step * Vec2::Unit(point);
      EXPECT_NEAR((energy(gaps + aside) - energy(gaps - aside)) / (2 * step), force(point), 1e-8);
    }
  }
}

TEST(NoTensionBed, OpensWhenTheForceLeavesTheMiddleThird) {
  for (const double lever : levers) {
    const double bed = 3 * lever * lever;
    const auto eccentricity = [&](double mean) {  // over the length of the stretch
      const Vec2 force = press_bed(stiffness, lever, gaps_at(lever, mean, 1)).force;
      return -lever * (force(1) - force(0)) / force.sum() / 2;
    };
    EXPECT_NEAR(std::abs(eccentricity(-bed)), 1.0 / 6, 1e-12);
    EXPECT_FALSE(open_ends(lever, gaps_at(lever, -bed - 1e-9, 1)).second);
    EXPECT_TRUE(open_ends(lever, gaps_at(lever, -bed + 1e-9, 1)).second);
    EXPECT_TRUE(open_ends(lever, gaps_at(lever, -bed + 1e-9, -1)).first);
    EXPECT_NEAR(std::abs(eccentricity(1 - 1e-9)), 0.5, 1e-8);
    EXPECT_TRUE(press_bed(stiffness, lever, gaps_at(lever, 1 + 1e-9, 1)).force.isZero(0));
  }
}

TEST(NoTensionBed, StandsWhereItJustTouches) {
  const BedAnswer touch = press_bed(100, 0.4, Vec2::Zero());
  EXPECT_TRUE(touch.force.isZero(0));
  EXPECT_EQ(touch.slope, Vec2::Constant(100));
  EXPECT_FALSE(open_ends(0.4, Vec2::Zero()).first);
  EXPECT_TRUE(open_ends(0.4, Vec2::Constant(1e-300)).first);
}

// The line through the gaps of the two points, followed to the ends of the stretch.
TEST(NoTensionBed, DeepestEndIsBeyondThePoints) {
  const double lever = 0.32;
  const auto gap_at = [&](const Vec2& gaps, double place) {
    return gaps(0) + (place + lever) / (2 * lever) * (gaps(1) - gaps(0));
  };
  for (const Vec2& gaps : {Vec2(-1, -1), Vec2(-0.3, 0.1), Vec2(0.7, -0.2), Vec2(0.2, 0.3), Vec2(2, 0.1)}) {
    const double deepest = -std::min(gap_at(gaps, -1), gap_at(gaps, 1));
    EXPECT_NEAR(deepest_end(lever, gaps), deepest, 1e-14);
    EXPECT_EQ(press_bed(stiffness, lever, gaps).force.isZero(0), deepest <= 0);
  }
}

// Neighbouring pieces meet without a jump of force or slope, but for the first touch.
TEST(NoTensionBed, ClosedPieceIsTwoSpringsOfTheirOwn) {
  const Vec2 gaps = gaps_at(0.32, -1, 0.9);
  const BedAnswer closed = press_bed(stiffness, 0.32, gaps);
  EXPECT_EQ(closed.force, Vec2(stiffness * gaps));
  EXPECT_EQ(closed.slope, Vec2::Constant(stiffness));
  EXPECT_EQ(closed.coupling, 0);
  const double edge = -3 * 0.32 * 0.32;
  const BedAnswer before = press_bed(stiffness, 0.32, gaps_at(0.32, edge - 1e-12, 1));
  const BedAnswer after = press_bed(stiffness, 0.32, gaps_at(0.32, edge + 1e-12, 1));
  EXPECT_LT((before.force - after.force).norm(), 1e-10);
  EXPECT_LT((before.slope - after.slope).norm(), 1e-9);
  EXPECT_LT(std::abs(after.coupling), 1e-9);
}

}  // namespace
}  // namespace dda
