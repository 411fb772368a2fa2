#include "engine/cutting/joint_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/core/error.h"
#include "engine/cutting/cutting_test_support.h"

namespace dda {
namespace {

constexpr double degree = std::numbers::pi / 180;

struct Moments {
  double mean = 0;
  double deviation = 0;
};

Moments moments_of(const RandomQuantity& quantity, int count) {
  RandomStream random(1, 0);
  double sum = 0;
  double squares = 0;
  for (int i = 0; i < count; ++i) {
    const double value = random.sample(quantity);
    sum += value;
    squares += value * value;
  }
  const double mean = sum / count;
  return {mean, std::sqrt(squares / count - mean * mean)};
}

// Standard errors of 1e5 samples: of the mean deviation/316, of the deviation, for the heaviest tail here, 0.6 %.
TEST(RandomStream, DistributionsHaveTheirMoments) {
  constexpr int count = 100'000;
  const auto expect = [&](const RandomQuantity& quantity, double deviation) {
    const Moments moments = moments_of(quantity, count);
    EXPECT_NEAR(moments.mean, quantity.mean, 4 * deviation / std::sqrt(count));
    EXPECT_NEAR(moments.deviation, deviation, 0.025 * deviation);
  };
  expect({2, 0.3, 0, Spread::normal}, 0.3);
  expect({2, 0.3, 0, Spread::uniform}, 0.3 / std::sqrt(3));
  expect({2, 0, 0, Spread::exponential}, 2);
  expect({2, 1, 0, Spread::lognormal}, 1);
  // At a large concentration von Mises is normal with a variance of 1/kappa, to the first order in 1/kappa.
  expect({1, 0, 100, Spread::fisher}, 0.1);
}

// Bits that any computer must give: the generator is fixed by the standard, uniform numbers use whole arithmetic only.
TEST(RandomStream, BitsAreFixed) {
  RandomStream random(1, 0);
  const double first = random.uniform();
  RandomStream again(1, 0);
  EXPECT_EQ(again.uniform(), first);
  RandomStream other(1, 1);
  EXPECT_NE(other.uniform(), first);
}

JointSet level_set(double spacing) {
  JointSet set;
  set.name = "level";
  set.origin = "joint_sets[0]";
  set.spacing.mean = spacing;
  set.start = Vec2(5, 5);
  return set;
}

const Ring square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};

TEST(JointSets, LinesLieApartByTheSpacing) {
  JointSet set = level_set(2);
  set.dip.mean = 30 * degree;
  const auto lines = traces_of({set}, square, 1);
  std::vector<double> heights;
  const Vec2 across(-std::sin(30 * degree), std::cos(30 * degree));
  for (const PlanLine& line : lines) {
    const Vec2 along = (line.points[1] - line.points[0]).normalized();
    EXPECT_NEAR(along.dot(across), 0, 1e-12);
    heights.push_back((line.points[0] - Vec2(5, 5)).dot(across));
  }
  std::sort(heights.begin(), heights.end());
  ASSERT_EQ(heights.size(), 7U);  // the square reaches 6.83 to either side: 0, 2, 4, 6 and back
  for (std::size_t i = 0; i < heights.size(); ++i) EXPECT_NEAR(heights[i], 2 * static_cast<double>(i) - 6, 1e-12);
}

TEST(JointSets, TracesAndBridgesShareALine) {
  JointSet set = level_set(100);
  set.length = RandomQuantity{1.5, 0, 0, Spread::none};
  set.bridge.mean = 0.5;
  const auto lines = traces_of({set}, square, 1);
  ASSERT_EQ(lines.size(), 5U);  // middles at 5, 5 +- 2, 5 +- 4
  for (const PlanLine& line : lines) {
    EXPECT_NEAR((line.points[1] - line.points[0]).norm(), 1.5, 1e-12);
    EXPECT_NEAR(std::remainder((line.points[0].x() + line.points[1].x()) / 2 - 5, 2), 0, 1e-12);
  }
}

// Joint per area: traces of a share p of every line, lines 1/spacing apart. 400 lines give it to 1 %.
TEST(JointSets, DensityIsThatOfSpacingAndPersistence) {
  const Ring wide{{0, 0}, {200, 0}, {200, 200}, {0, 200}};
  JointSet set = level_set(1);
  set.start.reset();
  set.dip = {40 * degree, 0, 200, Spread::fisher};
  set.spacing = {0.5, 0, 0, Spread::exponential};
  set.length = RandomQuantity{4, 1, 0, Spread::lognormal};
  set.bridge = {2, 0.5, 0, Spread::lognormal};
  double length = 0;
  for (const PlanLine& line : traces_of({set}, wide, 3)) {
    // of each trace the part in the middle of the rock, where its surroundings are whole
    const Segment trace{line.points[0], line.points[1]};
    for (int i = 0; i < 20; ++i) {
      const Vec2 point = point_at(trace, (i + 0.5) / 20);
      if ((point - Vec2(100, 100)).cwiseAbs().maxCoeff() < 80) length += (trace.end - trace.start).norm() / 20;
    }
  }
  EXPECT_NEAR(length / (160 * 160), 4.0 / 6 / 0.5, 0.1);
}

TEST(JointSets, TracesEndAtEarlierSets) {
  JointSet cross = level_set(3);
  cross.name = "cross";
  cross.dip.mean = 90 * degree;
  cross.length = RandomQuantity{4, 0, 0, Spread::none};
  cross.ends_at = {"level"};
  const auto lines = traces_of({level_set(1), cross}, square, 1);
  int checked = 0;
  for (const PlanLine& line : lines) {
    const Vec2 along = line.points[1] - line.points[0];
    if (std::abs(along.x()) > std::abs(along.y())) continue;
    ++checked;
    EXPECT_LE(along.norm(), 1 + 1e-9);
  }
  EXPECT_GT(checked, 5);
}

TEST(JointSets, ARegionCutsTraces) {
  JointSet set = level_set(1);
  set.region = {{2, 2}, {4, 2}, {4, 8}, {2, 8}};
  for (const PlanLine& line : traces_of({set}, square, 1)) {
    for (const Vec2& end : line.points) {
      EXPECT_GE(end.x(), 2 - 1e-12);
      EXPECT_LE(end.x(), 4 + 1e-12);
    }
  }
}

TEST(JointSets, OneSetDoesNotChangeAnother) {
  JointSet set = level_set(1);
  set.start.reset();
  set.spacing = {1, 0.2, 0, Spread::normal};
  JointSet other = set;
  other.spacing.mean = 0.5;
  const auto alone = traces_of({set}, square, 5);
  const auto together = traces_of({set, other}, square, 5);
  ASSERT_GT(together.size(), alone.size());
  for (std::size_t i = 0; i < alone.size(); ++i) EXPECT_EQ(alone[i].points, together[i].points);
}

TEST(JointSets, AnUnknownEarlierSetIsRefused) {
  JointSet set = level_set(1);
  set.ends_at = {"bedding"};
  EXPECT_THROW(traces_of({set}, square, 1), InputError);
}

// All lines from the start to the rock would be drawn.
TEST(JointSets, AStartOutOfReachIsRefused) {
  JointSet set = level_set(1);
  set.origin = "joint_sets[0]";
  for (const double far : {1e9, 1e20}) {
    set.start = Vec2(0, far);
    try {
      traces_of({set}, square, 1);
      ADD_FAILURE() << far;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("joint_sets[0].start"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace dda
