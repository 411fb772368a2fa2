#include "engine/terms/bolt.h"

#include <gtest/gtest.h>

#include <limits>

namespace dda {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// k = 10 along, 4 across; goes slack, yields at 6 along and at 2 across.
BoltLaw cable() { return {{10, 4}, {0, -2}, {6, 2}}; }
BoltLaw bar() { return {{10, 0}, {-6, -infinite}, {6, infinite}}; }

TEST(Bolt, ForceIsLinearBetweenItsBounds) {
  EXPECT_EQ(bolt_answer(cable(), {0.5, -0.25}).force, Vec2(5, -1));
  EXPECT_EQ(bolt_answer(cable(), {0.5, -0.25}).active, Vec2(1, 1));
  EXPECT_EQ(bolt_answer(cable(), {-0.5, 0.7}).force, Vec2(0, 2));
  EXPECT_EQ(bolt_answer(cable(), {-0.5, 0.7}).active, Vec2(0, 0));
  EXPECT_EQ(bolt_answer(cable(), {0.7, -9}).force, Vec2(6, -2));
  EXPECT_EQ(bolt_answer(bar(), {-0.5, 3}).force, Vec2(-5, 0));
  EXPECT_EQ(bolt_answer(bar(), {-0.7, 3}).force, Vec2(-6, 0));
}

// A cable that is slack keeps its length; what yields does not.
TEST(Bolt, OnlyYieldingIsPlastic) {
  EXPECT_EQ(elastic_part(cable(), {0.5, -0.25}), Vec2(0.5, -0.25));
  EXPECT_EQ(elastic_part(cable(), {-0.5, 0.75}), Vec2(-0.5, 0.5));
  EXPECT_EQ(elastic_part(cable(), {0.7, -0.75}), Vec2(0.6, -0.5));
  EXPECT_EQ(elastic_part(bar(), {-0.7, 3}), Vec2(-0.6, 3));
}

// Forces never fall with the gap: their potential is convex, which the line search needs.
TEST(Bolt, ForceIsTheGradientOfAConvexPotential) {
  for (const BoltLaw& law : {cable(), bar()}) {
    Vec2 before(-infinite, -infinite);
    for (double gap = -2; gap <= 2; gap += 0.01) {
      const Vec2 force = bolt_answer(law, {gap, gap}).force;
      EXPECT_GE(force(0), before(0));
      EXPECT_GE(force(1), before(1));
      before = force;
    }
  }
}

TEST(Bolt, EnergyIsThatOfItsSprings) {
  EXPECT_EQ(bolt_energy(cable(), {5, -1}), 25.0 / 20 + 1.0 / 8);
  EXPECT_EQ(bolt_energy(bar(), {-5, 0}), 25.0 / 20);
}

// Along and across are what the distance of the anchors, and a step aside of it, change by.
TEST(Bolt, RowsAreDerivativesOfTheDistance) {
  const Vec2 arm_a(0.4, -0.3);
  const Vec2 arm_b(-0.2, 0.7);
  const Vec2 span(3, 4);
  const BoltRows rows = bolt_rows(span / 5, arm_a, arm_b);
  constexpr double step = 1e-6;  // truncation step^2/5, round-off 1e-16/step
  for (int i = 0; i < 6; ++i) {
    const Vec2 by_a = displacement_rows(arm_a).col(i);
    const Vec2 by_b = displacement_rows(arm_b).col(i);
    EXPECT_NEAR(rows.a(0, i), ((span - step * by_a).norm() - (span + step * by_a).norm()) / (2 * step), 1e-9);
    EXPECT_NEAR(rows.b(0, i), ((span + step * by_b).norm() - (span - step * by_b).norm()) / (2 * step), 1e-9);
    EXPECT_NEAR(rows.a(1, i), -(Vec2(-0.8, 0.6).dot(by_a)), 1e-15);
    EXPECT_NEAR(rows.b(1, i), Vec2(-0.8, 0.6).dot(by_b), 1e-15);
  }
}

}  // namespace
}  // namespace dda
