#include "engine/geometry/diameter.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "engine/geometry/box.h"
#include "engine/geometry/random_polygon.h"

namespace dda {
namespace {

double by_all_pairs(const std::vector<Vec2>& points) {
  double largest = 0;
  for (const Vec2& a : points)
    for (const Vec2& b : points) largest = std::max(largest, (a - b).norm());
  return largest;
}

TEST(Diameter, OfFewPoints) {
  EXPECT_EQ(diameter({}), 0);
  EXPECT_EQ(diameter({{3, 4}}), 0);
  EXPECT_EQ(diameter({{3, 4}, {3, 4}}), 0);
  EXPECT_EQ(diameter({{0, 0}, {3, 4}}), 5);
  EXPECT_EQ(diameter({{0, 0}, {1, 0}, {2, 0}, {7, 0}}), 7);
}

TEST(Diameter, OfARectangleAlongTheAxesIsItsDiagonal) {
  const Ring ring{{0.1, -3.7}, {11.3, -3.7}, {11.3, 2.9}, {0.1, 2.9}};
  const Box box = bounding_box(ring);
  EXPECT_EQ(diameter(ring), (box.upper - box.lower).norm());
}

RC_GTEST_PROP(DiameterProperties, IsTheLargestOfAllDistances, ()) {
  std::vector<Vec2> points = random::star();
  const int more = random::integer(0, 60);
  for (int i = 0; i < more; ++i) points.push_back(random::point(random::number(0.1, 10)));
  RC_ASSERT(diameter(points) == by_all_pairs(points));
}

// Points on lines and in rows, where many lie on the sides of the hull and many distances are equal.
RC_GTEST_PROP(DiameterProperties, OfPointsOnALattice, ()) {
  std::vector<Vec2> points;
  const int count = random::integer(1, 40);
  for (int i = 0; i < count; ++i) points.emplace_back(random::integer(0, 5), random::integer(0, 4));
  RC_ASSERT(diameter(points) == by_all_pairs(points));
}

}  // namespace
}  // namespace dda
