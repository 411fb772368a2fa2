#include "engine/geometry/edge_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace dda {
namespace {

// A ring of so many corners around a centre, each at a distance drawn between half of the radius and all of it.
Ring star(const Vec2& centre, double radius, int corners, std::mt19937& random) {
  std::uniform_real_distribution<double> share(0.5, 1);
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    ring.push_back(centre + share(random) * radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

// A star with holes in its middle, which turn either way.
Polygon with_holes(std::mt19937& random) {
  Polygon polygon{star({3, -2}, 10, 200, random), {}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      Ring hole = star({1.5 + 1.5 * i, -3.5 + 1.5 * j}, 0.7, 30, random);
      if ((i + j) % 2 == 0) std::reverse(hole.begin(), hole.end());
      polygon.holes.push_back(hole);
    }
  return polygon;
}

// Random points, and those that rays through corners and points on edges may be wrong about.
TEST(EdgeIndex, LocatesAsLookingAtAllEdgesDoes) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-12, 12);
  for (int run = 0; run < 10; ++run) {
    const Polygon polygon = with_holes(random);
    const EdgeIndex index(polygon);
    std::vector<Vec2> points;
    for (int i = 0; i < 500; ++i) points.emplace_back(3 + place(random), -2 + place(random));
    for (const Segment& edge : index.edges()) {
      points.push_back(edge.start);
      points.push_back((edge.start + edge.end) / 2);
      points.emplace_back(3 + place(random), edge.start.y());
    }
    for (const Vec2& point : points)
      for (const double tolerance : {0.0, 1e-9, 0.05})
        EXPECT_EQ(index.locate(point, tolerance), locate(polygon, point, tolerance)) << point.transpose();
  }
}

TEST(EdgeIndex, FindsTheEdgesWhoseBoxesMeetABox) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-12, 12);
  const Polygon polygon = with_holes(random);
  const EdgeIndex index(polygon);
  EXPECT_EQ(index.edges().size(), corner_count(polygon));
  for (int i = 0; i < 300; ++i) {
    const Box box = expanded(expanded(Box{}, Vec2(place(random), place(random))), Vec2(place(random), place(random)));
    std::vector<int> expected;
    for (std::size_t k = 0; k < index.edges().size(); ++k) {
      const auto& [a, b] = index.edges()[k];
      if (overlap(expanded(expanded(Box{}, a), b), box)) expected.push_back(static_cast<int>(k));
    }
    EXPECT_EQ(index.near(box), expected);
  }
}

}  // namespace
}  // namespace dda
