#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <numbers>

#include "engine/geometry/polygon.h"
#include "engine/geometry/random_polygon.h"
#include "engine/geometry/rotation.h"

namespace dda {
namespace {

const Ring square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};

Ring box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

std::string reason(const Polygon& polygon) { return defect(polygon).value_or("valid"); }

TEST(PolygonDefect, ValidPolygonsHaveNone) {
  EXPECT_EQ(reason({square, {}}), "valid");
  EXPECT_EQ(reason({{{0, 0}, {1, 0}, {0, 1}}, {}}), "valid");
  EXPECT_EQ(reason({{{0, 4}, {4, 4}, {4, 0}, {0, 0}}, {}}), "valid");  // clockwise
  EXPECT_EQ(reason({{{0, 0}, {2, 0}, {4, 0}, {4, 4}}, {}}), "valid");  // vertex within an edge
  EXPECT_EQ(reason({square, {box(1, 1, 2, 2), box(2.5, 1, 3, 2)}}), "valid");
  EXPECT_EQ(reason({{{0, 0}, {1000, 0}, {1000, 1e-6}}, {}}), "valid");                   // thin, but no line
  EXPECT_EQ(reason({{{1e6, 1e6}, {1e6 + 1e-3, 1e6}, {1e6, 1e6 + 1e-3}}, {}}), "valid");  // small and far away
}

TEST(PolygonDefect, FewerThanThreeVertices) {
  EXPECT_EQ(reason({{}, {}}), "degenerate: the outer ring has fewer than 3 vertices (0)");
  EXPECT_EQ(reason({square, {{{1, 1}, {2, 2}}}}), "degenerate: hole 0 has fewer than 3 vertices (2)");
}

TEST(PolygonDefect, CoordinatesOutOfRange) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(reason({{{0, 0}, {1, 0}, {nan, 1}}, {}}), "out of range: vertex 2 of the outer ring is (nan, 1) m");
  EXPECT_EQ(reason({{{0, 0}, {1, nan}, {0, 1}}, {}}), "out of range: vertex 1 of the outer ring is (1, nan) m");
  EXPECT_EQ(reason({square, {{{1, 1}, {2, infinity}, {1, 2}}}}), "out of range: vertex 1 of hole 0 is (2, inf) m");
  EXPECT_EQ(reason({{{0, 0}, {1e300, 0}, {0, 1e300}}, {}}),
            "out of range: vertex 1 of the outer ring is (1e+300, 0) m");
}

TEST(PolygonDefect, RepeatedVertices) {
  EXPECT_EQ(reason({{{0, 0}, {1, 0}, {1, 0}, {0, 1}}, {}}), "degenerate: vertex 2 of the outer ring repeats vertex 1");
  EXPECT_EQ(reason({{{0, 0}, {1, 0}, {0, 1}, {0, 0}}, {}}), "degenerate: vertex 3 of the outer ring repeats vertex 0");
  // Two triangles that meet in a vertex.
  EXPECT_EQ(reason({{{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}, {}}),
            "degenerate: vertex 4 of the outer ring repeats vertex 1");
}

TEST(PolygonDefect, NoArea) {
  EXPECT_EQ(reason({{{0, 0}, {1, 1}, {2, 2}}, {}}), "degenerate: the outer ring has no area");
  EXPECT_EQ(reason({{{0, 0}, {3, 0}, {2, 0}, {1, 0}}, {}}), "degenerate: the outer ring has no area");
  EXPECT_EQ(reason({{{1, 1}, {1, 1}, {1, 1}}, {}}), "degenerate: the outer ring has no area");
  EXPECT_EQ(reason({square, {{{1, 1}, {2, 1}, {3, 1}}}}), "degenerate: hole 0 has no area");
  EXPECT_EQ(reason({{{0, 0}, {1e-100, 0}, {0, 1e-100}}, {}}).substr(0, 23), "degenerate: its area is");
}

TEST(PolygonDefect, SelfIntersection) {
  // A figure of eight, whose signed area is zero.
  EXPECT_EQ(reason({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}}),
            "self-intersecting: edge 0 of the outer ring crosses or touches edge 2");
  // A vertex that touches another edge from inside.
  EXPECT_EQ(reason({{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}, {}}),
            "self-intersecting: edge 0 of the outer ring crosses or touches edge 2");
  // A spike without width, at the middle and at the end of the ring.
  EXPECT_EQ(reason({{{0, 0}, {4, 0}, {6, 0}, {4, 0}, {4, 4}}, {}}),
            "degenerate: vertex 3 of the outer ring repeats vertex 1");
  EXPECT_EQ(reason({{{0, 0}, {6, 0}, {4, 0}, {4, 4}}, {}}),
            "self-intersecting: edge 0 of the outer ring folds back onto edge 1");
  EXPECT_EQ(reason({{{2, 0}, {6, 0}, {0, 0}, {4, 4}}, {}}),
            "self-intersecting: edge 0 of the outer ring folds back onto edge 1");
  EXPECT_EQ(reason({{{6, 0}, {4, 0}, {4, 4}, {0, 0}}, {}}),
            "self-intersecting: edge 0 of the outer ring folds back onto edge 3");
}

TEST(PolygonDefect, HolesThatTouchOrCross) {
  EXPECT_EQ(reason({square, {box(1, 1, 5, 2)}}), "self-intersecting: hole 0 crosses or touches the outer ring");
  EXPECT_EQ(reason({square, {box(0, 1, 1, 2)}}), "self-intersecting: hole 0 crosses or touches the outer ring");
  EXPECT_EQ(reason({square, {{{0, 2}, {1, 1}, {1, 3}}}}),
            "self-intersecting: hole 0 crosses or touches the outer ring");
  EXPECT_EQ(reason({square, {square}}), "self-intersecting: hole 0 crosses or touches the outer ring");
  EXPECT_EQ(reason({square, {box(1, 1, 2, 2), box(2, 1, 3, 2)}}),
            "self-intersecting: hole 1 crosses or touches hole 0");
}

TEST(PolygonDefect, HolesInTheWrongPlace) {
  EXPECT_EQ(reason({square, {box(5, 1, 6, 2)}}), "inconsistent: hole 0 lies outside the outer ring");
  EXPECT_EQ(reason({square, {box(-1, -1, 5, 5)}}), "inconsistent: hole 0 lies outside the outer ring");
  EXPECT_EQ(reason({square, {box(1, 1, 3, 3), box(1.5, 1.5, 2, 2)}}), "inconsistent: hole 1 lies inside hole 0");
  EXPECT_EQ(reason({square, {box(1.5, 1.5, 2, 2), box(1, 1, 3, 3)}}), "inconsistent: hole 0 lies inside hole 1");
}

Ring circle(int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    ring.push_back({std::cos(angle), std::sin(angle)});
  }
  return ring;
}

TEST(PolygonDefect, ReadsManyVerticesQuickly) {
  EXPECT_EQ(reason({circle(100'000), {}}), "valid");  // all pairs of edges would take minutes
}

TEST(PolygonDefect, ReadsManyHolesInManyVerticesQuickly) {
  Polygon sieve = {circle(100'000), {}};
  for (double x = -0.6; x < 0.59; x += 0.01)  // each hole against each edge would take minutes
    for (double y = -0.6; y < 0.59; y += 0.01) sieve.holes.push_back(box(x, y, x + 0.005, y + 0.005));
  EXPECT_EQ(reason(sieve), "valid");
  sieve.holes.push_back(box(0.8, 0.8, 0.81, 0.81));
  EXPECT_EQ(reason(sieve), fmt::format("inconsistent: hole {} lies outside the outer ring", sieve.holes.size() - 1));
}

RC_GTEST_PROP(PolygonDefectProperty, StarsAreValidWhereverTheyLie, ()) {
  const Polygon polygon = random::polygon();
  const Mat2 turn = rotation(random::number(-3.2, 3.2));
  RC_ASSERT(defect(random::transformed(polygon, turn, 1e6 * random::point(1))) == std::nullopt);
}

RC_GTEST_PROP(PolygonDefectProperty, NoSimpleRingTurnsTwice, ()) {
  Ring twice = random::star();
  const Ring inner = random::scaled(random::star(), random::number(0.25, 0.75));
  twice.insert(twice.end(), inner.begin(), inner.end());
  RC_ASSERT(defect({twice, {}}) != std::nullopt);
}

RC_GTEST_PROP(PolygonDefectProperty, ADrawnInHoleIsValidAndAShiftedOneIsNot, ()) {
  const Ring outer = random::star();
  const Ring hole = random::scaled(outer, 0.5);
  RC_ASSERT(defect({outer, {hole}}) == std::nullopt);
  // Moved by more than the radius of the outer ring, so that some of it must leave.
  const double angle = random::number(-3.2, 3.2);
  const Vec2 shift = 2.1 * Vec2(std::cos(angle), std::sin(angle));
  RC_ASSERT(defect({outer, {random::transformed({hole, {}}, Mat2::Identity(), shift).outer}}) != std::nullopt);
}

// Square holes in rows, apart from each other.
Polygon with_holes(int rows) {
  Polygon polygon = {box(0, 0, rows, rows), {}};
  for (int i = 0; i < rows * rows; ++i) {
    const double x = i % rows + 0.25;
    const double y = i / rows + 0.25;
    polygon.holes.push_back(box(x, y, x + 0.5, y + 0.5));
  }
  return polygon;
}

double seconds_to_check(const Polygon& polygon) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const std::clock_t began = std::clock();
    EXPECT_FALSE(defect(polygon).has_value());
    least = std::min(least, static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC);
  }
  return least;
}

// Sixteen times as many holes take about sixteen times as long where each is compared with its neighbours, and 256
// times where it is compared with all; the bound is half-way in powers of ten.
TEST(PolygonDefect, ManyHolesAreComparedWithThoseNearOnly) {
  EXPECT_LE(seconds_to_check(with_holes(80)), 64 * seconds_to_check(with_holes(20)));
}

TEST(PolygonDefect, OneHoleInAnotherIsFoundAmongMany) {
  Polygon polygon = with_holes(20);
  polygon.holes.push_back(box(7.4, 5.4, 7.6, 5.6));
  EXPECT_EQ(defect(polygon), "inconsistent: hole 400 lies inside hole 107");
}

}  // namespace
}  // namespace dda
