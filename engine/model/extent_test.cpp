#include "engine/model/extent.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "engine/geometry/rotation.h"

namespace dda {
namespace {

// Two boxes side by side, 3 m long, and one on top of the first: from its upper left corner to the lower right one.
TEST(Extent, DiameterIsTheSameWhicheverWayTheSceneIsTurned) {
  for (const double angle : {0.0, 0.3, 1.5, -2.0}) {
    Model model;
    for (const Ring& drawn : {Ring{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, Ring{{2, 0}, {3, 0}, {3, 1}, {2, 1}},
                              Ring{{0, 1}, {2, 1}, {2, 2}, {0, 2}}}) {
      Ring& ring = model.blocks.emplace_back().shape.outer;
      for (const Vec2& corner : drawn) ring.emplace_back(rotation(angle) * corner);
    }
    EXPECT_NEAR(diameter(model), std::hypot(3, 2), 1e-12) << angle;
  }
}

// Corners that lie too far inside to count are left out: the answer is that of all pairs, to the last bit.
TEST(Extent, DiameterIsThatOfTheFarthestTwoCorners) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int population = 0; population < 200; ++population) {
    const double wide = std::exp(normal(random)), slant = normal(random);
    Model model;
    std::vector<Vec2> corners;
    for (int i = 0; i < 3 + population; ++i) {
      const double x = normal(random), y = normal(random);
      corners.emplace_back(wide * x, y + slant * x);
      model.blocks.emplace_back().shape.outer.push_back(corners.back());
    }
    double largest = 0;
    for (const Vec2& one : corners)
      for (const Vec2& other : corners) largest = std::max(largest, (one - other).norm());
    EXPECT_EQ(diameter(model), largest) << population;
  }
}

}  // namespace
}  // namespace dda
