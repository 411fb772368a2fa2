#include "engine/geometry/segment.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "engine/geometry/random_polygon.h"
#include "engine/geometry/rotation.h"

namespace dda {
namespace {

// Coordinates up to 4 m, a few dozen operations: 4 * 50 * 1.1e-16 = 2e-14 m, with a margin of fifty for the division
// by the length of a short segment.
constexpr double round_off = 1e-12;

const Segment unit = {{0, 0}, {1, 0}};

TEST(Segment, ClosestPoint) {
  EXPECT_EQ(closest_point(unit, {0.25, 3}), Vec2(0.25, 0));
  EXPECT_EQ(closest_point(unit, {-1, 1}), Vec2(0, 0));
  EXPECT_EQ(closest_point(unit, {2, -1}), Vec2(1, 0));
  EXPECT_EQ(distance(unit, {4, 4}), 5);
  EXPECT_EQ(distance(Segment{{1, 1}, {1, 1}}, {4, 5}), 5);
}

RC_GTEST_PROP(SegmentProperty, NoPointOfItIsCloserThanTheClosest, ()) {
  const Segment segment = {random::point(2), random::point(2)};
  const Vec2 point = random::point(4);
  for (int i = 0; i <= 100; ++i) {
    RC_ASSERT((point_at(segment, i / 100.) - point).norm() >= distance(segment, point) - round_off);
  }
}

TEST(Segment, ProperIntersection) {
  const auto crossing = proper_intersection(unit, {{0.25, -1}, {0.25, 3}});
  ASSERT_TRUE(crossing.has_value());
  EXPECT_EQ(*crossing, Vec2(0.25, 0));
  EXPECT_FALSE(proper_intersection(unit, {{0.25, 0}, {0.25, 3}}).has_value());  // touches
  EXPECT_FALSE(proper_intersection(unit, {{1, -1}, {1, 1}}).has_value());       // touches with the end
  EXPECT_FALSE(proper_intersection(unit, {{0.25, 1}, {0.25, 3}}).has_value());
  EXPECT_FALSE(proper_intersection(unit, {{2, -1}, {2, 1}}).has_value());
  EXPECT_FALSE(proper_intersection(unit, {{0.5, 0}, {2, 0}}).has_value());  // collinear
}

RC_GTEST_PROP(SegmentProperty, TheIntersectionLiesOnBoth, ()) {
  const Segment a = {random::point(2), random::point(2)};
  const Segment b = {random::point(2), random::point(2)};
  const auto crossing = proper_intersection(a, b);
  RC_PRE(crossing.has_value());
  RC_PRE(std::abs(cross((a.end - a.start).normalized(), (b.end - b.start).normalized())) > 0.01);
  RC_ASSERT(distance(a, *crossing) <= 100 * round_off);  // conditioned by the sine of the angle, at least 0.01
  RC_ASSERT(distance(b, *crossing) <= 100 * round_off);
  RC_ASSERT(distance(a, b) == 0);
}

TEST(Segment, DistanceOfSegments) {
  EXPECT_EQ(distance(unit, Segment{{0.5, -1}, {0.5, 1}}), 0);
  EXPECT_EQ(distance(unit, Segment{{0.5, 0}, {0.5, 1}}), 0);
  EXPECT_EQ(distance(unit, Segment{{-3, 2}, {3, 2}}), 2);
  EXPECT_EQ(distance(unit, Segment{{4, 4}, {9, 4}}), 5);
  EXPECT_EQ(distance(Segment{{4, 4}, {9, 4}}, unit), 5);
}

RC_GTEST_PROP(SegmentProperty, DistanceIsTheLeastOverBoth, ()) {
  const Segment a = {random::point(2), random::point(2)};
  const Segment b = {random::point(2), random::point(2)};
  double least = 1e9;
  constexpr int count = 64;
  for (int i = 0; i <= count; ++i) least = std::min(least, distance(b, point_at(a, static_cast<double>(i) / count)));
  RC_ASSERT(distance(a, b) <= least + round_off);
  // Between two samples the distance falls by at most half their spacing.
  RC_ASSERT(distance(a, b) >= least - (a.end - a.start).norm() / (2 * count) - round_off);
}

TEST(Segment, CollinearOverlap) {
  const auto overlap = [](const Segment& other) { return collinear_overlap(unit, other, 1e-3); };
  using Stretch = std::pair<Vec2, Vec2>;
  EXPECT_EQ(overlap({{0.25, 0}, {0.5, 0}}), Stretch({0.25, 0}, {0.5, 0}));
  EXPECT_EQ(overlap({{0.5, 0}, {0.25, 0}}), Stretch({0.25, 0}, {0.5, 0}));  // the other way round
  EXPECT_EQ(overlap({{-1, 0}, {0.5, 0}}), Stretch({0, 0}, {0.5, 0}));
  EXPECT_EQ(overlap({{2, 0}, {-1, 0}}), Stretch({0, 0}, {1, 0}));
  EXPECT_EQ(overlap({{0.5, 9e-4}, {2, 9e-4}}), Stretch({0.5, 0}, {1, 0}));  // beside, within the tolerance
  EXPECT_FALSE(overlap({{0.5, 1.1e-3}, {2, 1.1e-3}}).has_value());
  EXPECT_FALSE(overlap({{1, 0}, {2, 0}}).has_value());         // end to end
  EXPECT_FALSE(overlap({{0.9995, 0}, {2, 0}}).has_value());    // a stretch shorter than the tolerance
  EXPECT_FALSE(overlap({{0.5, 0}, {1, 0.5}}).has_value());     // diverges
  EXPECT_FALSE(overlap({{0, -0.01}, {1, 0.01}}).has_value());  // crosses at a small angle
  EXPECT_FALSE(overlap({{0.5, -1}, {0.5, 1}}).has_value());
  EXPECT_FALSE(overlap({{0.5, 0}, {0.5, 0}}).has_value());
  EXPECT_FALSE(collinear_overlap({{0, 0}, {0, 0}}, unit, 1e-3).has_value());
}

RC_GTEST_PROP(SegmentProperty, TheOverlapIsThatOfTheIntervals, ()) {
  const double a0 = random::number(-2, 2), a1 = random::number(-2, 2);
  const double b0 = random::number(-2, 2), b1 = random::number(-2, 2);
  RC_PRE(a0 < a1);
  constexpr double tolerance = 1e-9;
  const Mat2 turn = rotation(random::number(-3.2, 3.2));
  const auto at = [&](double x) { return Vec2(turn * Vec2(x, 0.5)); };
  const auto stretch = collinear_overlap({at(a0), at(a1)}, {at(b0), at(b1)}, tolerance);
  const double first = std::max(a0, std::min(b0, b1));
  const double last = std::min(a1, std::max(b0, b1));
  RC_ASSERT(stretch.has_value() == (last - first > tolerance));
  if (!stretch) return;
  RC_ASSERT((stretch->first - at(first)).norm() <= round_off);
  RC_ASSERT((stretch->second - at(last)).norm() <= round_off);
}

}  // namespace
}  // namespace dda
