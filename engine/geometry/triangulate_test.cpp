#include "engine/geometry/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <stdexcept>
#include <utility>

#include "engine/geometry/segment.h"

namespace dda {
namespace {

Ring all_vertices(const Polygon& polygon) {
  Ring vertices = polygon.outer;
  for (const Ring& hole : polygon.holes) vertices.insert(vertices.end(), hole.begin(), hole.end());
  return vertices;
}

// Directed edges of the rings, material on the left.
std::vector<std::pair<int, int>> boundary_edges(const Polygon& polygon) {
  std::vector<std::pair<int, int>> edges;
  int first = 0;
  const auto add = [&](const Ring& ring, bool reversed) {
    const int n = static_cast<int>(ring.size());
    for (int i = 0; i < n; ++i) {
      const int a = first + i;
      const int b = first + (i + 1) % n;
      edges.push_back(reversed ? std::pair(b, a) : std::pair(a, b));
    }
    first += n;
  };
  add(polygon.outer, signed_area(polygon.outer) < 0);
  for (const Ring& hole : polygon.holes) add(hole, signed_area(hole) > 0);
  return edges;
}

// Number of triangles, edge to edge, positive, and the sum of areas: together only a true triangulation has them all.
void expect_triangulation(const Polygon& polygon) {
  ASSERT_EQ(defect(polygon).value_or(""), "");
  const Ring vertices = all_vertices(polygon);
  const std::vector<Triangle> triangles = triangulate(polygon);
  EXPECT_EQ(triangles.size(), vertices.size() + 2 * polygon.holes.size() - 2);

  double area = 0;
  double extent = 0;
  std::map<std::pair<int, int>, int> uses;
  for (const Triangle& triangle : triangles) {
    const auto corner = [&](std::size_t i) { return vertices[static_cast<std::size_t>(triangle[i % 3])]; };
    const double twice_area = cross(corner(1) - corner(0), corner(2) - corner(0));
    EXPECT_GT(twice_area, 0);
    area += twice_area / 2;
    for (std::size_t i = 0; i < 3; ++i) {
      ++uses[{triangle[i], triangle[(i + 1) % 3]}];
      extent = std::max(extent, (corner(i) - vertices[0]).cwiseAbs().maxCoeff());
    }
  }
  // Each product of differences is rounded to a few 2^-53 of extent^2; area_moments likewise.
  const double round_off = 1e-15 * extent * extent * static_cast<double>(triangles.size());
  EXPECT_NEAR(area, area_moments(polygon).area, round_off);

  for (const auto& edge : boundary_edges(polygon)) EXPECT_EQ(uses[edge]--, 1) << edge.first << "-" << edge.second;
  for (const auto& [edge, count] : uses) {
    if (count == 0) continue;
    EXPECT_EQ(count, 1);
    EXPECT_EQ(uses.at({edge.second, edge.first}), 1);  // an inner edge borders two triangles
  }
}

Ring square(double x, double y, double side) { return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}; }

Ring star(std::mt19937& random, int corners, const Vec2& centre, double inner, double outer) {
  std::uniform_real_distribution<double> radius(inner, outer);
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    ring.push_back(centre + radius(random) * Vec2(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

TEST(Triangulate, TriangleSquareAndClockwiseSquare) {
  expect_triangulation({{{0, 0}, {1, 0}, {0, 1}}, {}});
  expect_triangulation({square(0, 0, 1), {}});
  expect_triangulation({{{0, 0}, {0, 1}, {1, 1}, {1, 0}}, {}});
}

TEST(Triangulate, ConcaveBlocks) {
  expect_triangulation({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, {}});
  expect_triangulation({{{0, 0}, {4, 0}, {4, 4}, {2, 0.1}, {0, 4}}, {}});
}

TEST(Triangulate, FlatCorners) {
  expect_triangulation({{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}, {2, 3}, {0, 3}, {0, 1}}, {}});
  expect_triangulation({{{0, 0}, {1, 0}, {2, 0}, {1, 1}}, {}});
}

TEST(Triangulate, CombWithFlatBack) {
  Ring comb;
  for (int tooth = 0; tooth < 40; ++tooth) {
    comb.emplace_back(2 * tooth, 5);
    comb.emplace_back(2 * tooth + 1, 5);
    comb.emplace_back(2 * tooth + 1, 1);
    comb.emplace_back(2 * tooth + 2, 1);
  }
  comb.emplace_back(80, 0);
  for (int i = 79; i >= 0; --i) comb.emplace_back(i, 0);
  expect_triangulation({comb, {}});
}

TEST(Triangulate, Spiral) {
  Ring spiral;
  const auto turn = [](int i, double radius) {
    const double angle = i * std::numbers::pi / 8;
    return Vec2((radius + angle) * std::cos(angle), (radius + angle) * std::sin(angle));
  };
  for (int i = 0; i <= 64; ++i) spiral.push_back(turn(i, 3));
  for (int i = 64; i >= 0; --i) spiral.push_back(turn(i, 1));
  expect_triangulation({spiral, {}});
}

TEST(Triangulate, HoleOfEitherOrientation) {
  expect_triangulation({square(0, 0, 3), {square(1, 1, 1)}});
  expect_triangulation({square(0, 0, 3), {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}});
}

// All bridges and edges in line, the hardest case for inexact predicates.
TEST(Triangulate, GridOfHoles) {
  for (const double pitch : {1.0, 0.1}) {
    for (const double offset : {0.0, 1e5}) {
      Polygon polygon{square(offset, offset, 13 * pitch), {}};
      for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
          polygon.holes.push_back(square(offset + pitch * (2 * i + 1), offset + pitch * (2 * j + 1), pitch));
        }
      }
      expect_triangulation(polygon);
    }
  }
}

// Several bridges end at one corner of the outer ring.
TEST(Triangulate, BridgesThatShareAVertex) {
  Polygon polygon{{{0, 0}, {100, -100}, {100, 100}}, {}};
  for (int i = -3; i <= 3; ++i) {
    const Vec2 tip(10, 2 * i);
    polygon.holes.push_back({tip, tip + Vec2(-1, 0.5), tip + Vec2(-1, -0.5)});
  }
  expect_triangulation(polygon);
}

TEST(Triangulate, RandomStarsWithHoles) {
  std::mt19937 random(20240607);
  std::uniform_int_distribution<int> corners(3, 24);
  std::uniform_int_distribution<int> holes(0, 9);
  for (int repeat = 0; repeat < 300; ++repeat) {
    Polygon polygon{star(random, 60, {0, 0}, 20, 40), {}};
    const int count = holes(random);
    for (int i = 0; i < count; ++i) {
      const Vec2 centre(6 * (i % 3) - 6, 6 * (i / 3) - 6);
      polygon.holes.push_back(star(random, corners(random), centre, 0.5, 2.9));
    }
    expect_triangulation(polygon);
    if (HasFailure()) FAIL() << "repeat " << repeat;
  }
}

// Slanted rows of points that round-off puts a little off the line, either way.
TEST(Triangulate, NearlyFlatCorners) {
  Ring ring;
  for (int i = 0; i < 100; ++i) ring.emplace_back(0.1 * i, 0.7 * i);
  for (int i = 100; i > 0; --i) ring.emplace_back(0.1 * i - 0.3, 0.7 * i + 0.3);
  const Polygon polygon{ring, {}};
  const std::vector<Triangle> triangles = triangulate(polygon);
  EXPECT_EQ(triangles.size(), ring.size() - 2);
  double area = 0;
  for (const Triangle& t : triangles) {
    const auto corner = [&](std::size_t i) { return ring[static_cast<std::size_t>(t[i])]; };
    const double part = cross(corner(1) - corner(0), corner(2) - corner(0)) / 2;
    EXPECT_GT(part, -1e-12);  // positive in exact arithmetic; round-off of 2^-53 * 70^2
    area += part;
  }
  EXPECT_NEAR(area, area_moments(polygon).area, 1e-10);  // 200 terms of that round-off
}

TEST(Triangulate, RefusesCrossingRings) {
  EXPECT_THROW(triangulate({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}}), std::invalid_argument);
  EXPECT_THROW(triangulate({square(0, 0, 1), {square(5, 0.2, 0.5)}}), std::invalid_argument);
}

TEST(IsConvex, KnowsConcaveHolesAndFlatCorners) {
  EXPECT_TRUE(is_convex({square(0, 0, 1), {}}));
  EXPECT_TRUE(is_convex({{{0, 0}, {0, 1}, {1, 1}, {1, 0}}, {}}));
  EXPECT_TRUE(is_convex({{{0, 0}, {1, 0}, {2, 0}, {1, 1}}, {}}));
  EXPECT_FALSE(is_convex({{{0, 0}, {4, 0}, {4, 4}, {2, 0.1}, {0, 4}}, {}}));
  EXPECT_FALSE(is_convex({square(0, 0, 3), {square(1, 1, 1)}}));
}

}  // namespace
}  // namespace dda
