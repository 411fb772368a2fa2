// The bed against the sum of its springs, taken one by one, and what it is where it is stiffer than they.
#include "engine/contact/no_tension_bed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/geometry/cut_pieces.h"

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

// The share of such springs that press, of a bed of the law.
double pressed_share(double lever, double mean, double turn) {
  const double whole = 2 * stiffness;
  const double bed = 3 * lever * lever * whole;
  const Forces forces = forces_at(lever, mean, turn);
  const double gap_of_bed = mean + (1 / bed - 1 / whole) * forces.normal;
  return std::clamp((1 - gap_of_bed / std::abs(turn)) / 2, 0.0, 1.0);
}

Vec2 force_at(const Bed& bed, const Vec2& gaps) { return press_bed(bed, gaps).force; }

Mat2 slopes_at(const Bed& bed, const Vec2& gaps) {
  const BedAnswer answer = press_bed(bed, gaps);
  return (Mat2() << answer.slope(0), answer.coupling, answer.coupling, answer.slope(1)).finished();
}

TEST(NoTensionBed, IsClosedWhereSpringsPress) {
  for (const double lever : levers)
    for (const double mean : means)
      for (const double turn : {1.0, -1.0})
        EXPECT_NEAR(closed_share(lever, force_at({stiffness, lever}, gaps_at(lever, mean, turn))),
                    pressed_share(lever, mean, turn), 1e-4)  // 20,000 springs
            << lever << " " << mean;
}

// Whether or not the bed spreads its load.
TEST(NoTensionBed, KnowsHowTheClosedShareFollowsTheGaps) {
  constexpr double difference = 1e-6;
  for (const double lever : levers) {
    for (const double mean : means) {
      for (const double spread : {0.0, 0.4, 1.0}) {
        const Bed bed{stiffness, lever, spread};
        const Vec2 gaps = gaps_at(lever, mean, 1);
        const auto share_at = [&](const Vec2& at) { return closed_share(lever, force_at(bed, at)); };
        const Vec2 by_gaps = closed_share_by_gaps(lever, force_at(bed, gaps), slopes_at(bed, gaps));
        for (int point = 0; point < 2; ++point) {
          const Vec2 change = difference * Vec2::Unit(point);
          const double by = (share_at(gaps + change) - share_at(gaps - change)) / (2 * difference);
          EXPECT_NEAR(by_gaps(point), by, 1e-7) << lever << " " << mean << " " << spread;  // as its third derivative
        }
      }
    }
  }
}

// As equilibrium has it, however the bed yields.
TEST(NoTensionBed, ClosedShareIsThreeTimesTheDistanceFromTheEdge) {
  for (const double lever : levers) {
    for (const double spread : {0.0, 0.25, 1.0}) {
      for (const double from_edge : {0.001, 0.01, 0.05, 0.2, 0.3}) {  // over the length
        const double arm = (1 - 2 * from_edge) / lever;
        const Vec2 force = force_at({stiffness, lever, spread},
                                    gaps_of_bed({stiffness, lever, spread}, {-(1 + arm) / 2, -(1 - arm) / 2}));
        EXPECT_NEAR(closed_share(lever, force), 3 * from_edge, 1e-9) << lever << " " << spread;
      }
    }
  }
}

TEST(NoTensionBed, AnswersAsSpringsThatOnlyPress) {
  for (const double lever : levers) {
    for (const double mean : means) {
      for (const double turn : {1.0, -1.0}) {
        const Forces expected = forces_at(lever, mean, turn);
        const Vec2 force = press_bed({stiffness, lever}, gaps_at(lever, mean, turn)).force;
        // 20,000 springs miss the square of the share of one, and the one in which the joint begins to gape.
        EXPECT_NEAR(force.sum(), expected.normal, 1e-7) << lever << " " << mean;
        EXPECT_NEAR(lever * (force(1) - force(0)), expected.moment, 1e-7) << lever << " " << mean;
      }
    }
  }
}

TEST(NoTensionBed, OpensWhenTheForceLeavesTheMiddleThird) {
  for (const double lever : levers) {
    const double bed = 3 * lever * lever;
    const auto eccentricity = [&](double mean) {  // over the length of the stretch
      const Vec2 force = press_bed({stiffness, lever}, gaps_at(lever, mean, 1)).force;
      return -lever * (force(1) - force(0)) / force.sum() / 2;
    };
    EXPECT_NEAR(std::abs(eccentricity(-bed)), 1.0 / 6, 1e-12);
    EXPECT_FALSE(open_ends(lever, gaps_at(lever, -bed - 1e-9, 1)).second);
    EXPECT_TRUE(open_ends(lever, gaps_at(lever, -bed + 1e-9, 1)).second);
    EXPECT_TRUE(open_ends(lever, gaps_at(lever, -bed + 1e-9, -1)).first);
    EXPECT_NEAR(std::abs(eccentricity(1 - 1e-9)), 0.5, 1e-8);
    EXPECT_TRUE(press_bed({stiffness, lever}, gaps_at(lever, 1 + 1e-9, 1)).force.isZero(0));
  }
}

// ---- Beds that spread what presses a short part of them, drawn by lot.

struct Draw {
  Bed bed;
  Vec2 gaps;
};

// Draws a bed of any kind, pressed in part more often than not.
Draw any_bed(SeededNumbers& random) {
  const double lever = std::sqrt(random.number(0.05, 1) / 3);
  const double spread = random.chance(0.2) ? 0 : random.chance(0.2) ? 1 : random.number(0.01, 1);
  const double turn = (random.chance(0.5) ? 1 : -1) * random.magnitude(-3, 3);
  const double mean = random.chance(0.3) ? 1 - random.magnitude(-6, 0) : random.number(-1.2, 1.2);
  return {{random.magnitude(-2, 2), lever, spread}, gaps_at(lever, mean * std::abs(turn), turn)};
}

double stored(const Bed& bed, const Vec2& gaps) { return gaps.dot(press_bed(bed, gaps).force) / 2; }

// Forces are the slopes of half of force times gap, and the rows the slopes of forces. Differences over a step of 1e-5
// are wrong by its square and by round-off over it; over a place where slopes have a corner by the step.
TEST(NoTensionBed, ForcesAndSlopesFollowFromOnePotential) {
  SeededNumbers random(1);
  for (int i = 0; i < 20000; ++i) {
    const auto [bed, gaps] = any_bed(random);
    const double step = 1e-5 * gaps.norm();
    const BedAnswer here = press_bed(bed, gaps);
    for (const int point : {0, 1}) {
      const Vec2 aside = step * Vec2::Unit(point);
      const Vec2 more = press_bed(bed, gaps + aside).force, less = press_bed(bed, gaps - aside).force;
      const double force = (stored(bed, gaps + aside) - stored(bed, gaps - aside)) / (2 * step);
      EXPECT_NEAR(force, here.force(point), 1e-4 * bed.stiffness * gaps.norm()) << i;
      if (open_ends(bed.lever, gaps + aside).first != open_ends(bed.lever, gaps - aside).first) continue;
      if (open_ends(bed.lever, gaps + aside).second != open_ends(bed.lever, gaps - aside).second) continue;
      const Vec2 slope = (more - less) / (2 * step);
      EXPECT_NEAR(slope(point), here.slope(point), 2e-3 * bed.stiffness) << i;
      EXPECT_NEAR(slope(1 - point), here.coupling, 2e-3 * bed.stiffness) << i;
    }
  }
}

// What the sure passes live on: the potential of blocks and contacts is convex (open_close.h).
TEST(NoTensionBed, IsConvex) {
  SeededNumbers random(2);
  for (int i = 0; i < 200000; ++i) {
    const auto [bed, gaps] = any_bed(random);
    const BedAnswer here = press_bed(bed, gaps);
    const double sum = here.slope.sum();
    const double least = here.slope.prod() - here.coupling * here.coupling;
    EXPECT_GE(here.slope.minCoeff(), -1e-12 * bed.stiffness) << i;
    EXPECT_GE(least, -1e-9 * sum * sum) << i << " lever " << bed.lever << " spread " << bed.spread;
    const Vec2 other = gaps.norm() * random.number(0, 2) * random.direction();
    EXPECT_GE((other - gaps).dot(press_bed(bed, other).force - here.force),
              -1e-12 * bed.stiffness * (other - gaps).squaredNorm());
  }
}

// The closed part of a column without tension is three times as far as the force is from the edge.
double eccentricity_of_closed(double closed) { return 0.5 - closed / 3; }

// Gaps over the turn at which the force is so far from the middle, in lengths, by bisection.
Vec2 gaps_under(const Bed& bed, double eccentricity) {
  double low = -10, high = 1;
  for (int i = 0; i < 200; ++i) {
    const double middle = (low + high) / 2;
    const Vec2 force = press_bed(bed, gaps_at(bed.lever, middle, 1)).force;
    (bed.lever * (force(0) - force(1)) > 2 * eccentricity * force.sum() ? low : high) = middle;
  }
  return gaps_at(bed.lever, low, 1);
}

// How deep the end lies in the other for a force of 1.
double depth_under(const Bed& bed, double eccentricity) {
  const Vec2 gaps = gaps_under(bed, eccentricity);
  return -deepest_end(bed.lever, gaps) / press_bed(bed, gaps).force.sum();
}

TEST(NoTensionBed, SpreadsWhatPressesAShortPart) {
  for (const double lever : levers) {
    for (const double spread : {0.1, 0.25, 0.6, 1.0}) {
      const Bed column{stiffness, lever}, bed{stiffness, lever, spread};
      const auto both = [&](double closed) {
        return Vec2(depth_under(column, eccentricity_of_closed(closed)),
                    depth_under(bed, eccentricity_of_closed(closed)));
      };
      const Vec2 longer = both(1.05 * spread);
      EXPECT_NEAR(longer(1), longer(0), 1e-9 * longer(0)) << "a column where the closed part is longer";
      double before = longer(1);
      for (const double closed : {0.8, 0.4, 0.2, 0.1, 0.05}) {
        const Vec2 depth = both(closed * spread);
        EXPECT_LT(depth(1), depth(0)) << closed;
        EXPECT_GT(depth(1), before) << "and yet gives way the more, the less is closed";
        before = depth(1);
      }
      const double whole = 3 * lever * lever * 2 * stiffness;
      const double at_last = 2 / (whole * spread * spread_rise);
      EXPECT_NEAR(depth_under(bed, 0.5 - 1e-7) / at_last, 1, 1e-2) << "a spring at the end";
      EXPECT_GT(depth_under(column, eccentricity_of_closed(1e-4)), 100 * at_last * spread);
    }
  }
}

TEST(NoTensionBed, StandsWhereItJustTouches) {
  const BedAnswer touch = press_bed({100, 0.4}, Vec2::Zero());
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
    EXPECT_EQ(press_bed({stiffness, lever}, gaps).force.isZero(0), deepest <= 0);
  }
}

// Neighbouring pieces meet without a jump of force or slope, but for the first touch.
TEST(NoTensionBed, ClosedPieceIsTwoSpringsOfTheirOwn) {
  const Vec2 gaps = gaps_at(0.32, -1, 0.9);
  const BedAnswer closed = press_bed({stiffness, 0.32}, gaps);
  EXPECT_EQ(closed.force, Vec2(stiffness * gaps));
  EXPECT_EQ(closed.slope, Vec2::Constant(stiffness));
  EXPECT_EQ(closed.coupling, 0);
  const double edge = -3 * 0.32 * 0.32;
  const BedAnswer before = press_bed({stiffness, 0.32}, gaps_at(0.32, edge - 1e-12, 1));
  const BedAnswer after = press_bed({stiffness, 0.32}, gaps_at(0.32, edge + 1e-12, 1));
  EXPECT_LT((before.force - after.force).norm(), 1e-10);
  EXPECT_LT((before.slope - after.slope).norm(), 1e-9);
  EXPECT_LT(std::abs(after.coupling), 1e-9);
}

// Where a bed is stiffer than a column the closed part is found by bisection, to the last bits of its force.
TEST(NoTensionBed, IsFoundByItsForces) {
  for (const double lever : levers)
    for (const double spread : {0.0, 0.25, 1.0})
      for (const double mean : means)
        for (const double turn : {1.0, -1.0}) {
          const Bed bed{stiffness, lever, spread};
          const Vec2 gaps = gaps_at(lever, mean, turn);
          const Vec2 force = press_bed(bed, gaps).force;
          if (force.isZero(0)) continue;
          // 0.99 leaves a closed part of 0.005, whose forces lose as many digits.
          EXPECT_LT((gaps_of_bed(bed, force) - gaps).norm(), 1e-10) << lever << " " << spread << " " << mean;
        }
}

}  // namespace
}  // namespace dda
