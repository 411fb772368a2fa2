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

Model triangle_at(const Vec2& place, double size, std::mt19937& random) {
  std::uniform_real_distribution<double> within(-size / 2, size / 2);
  Model model;
  Ring& ring = model.blocks.emplace_back().shape.outer;
  for (int i = 0; i < 3; ++i) ring.emplace_back(place + Vec2(within(random), within(random)));
  return model;
}

TEST(Extent, ASceneBesideTheOriginOfItsDrawingKeepsThat) {
  std::mt19937 random(5);
  for (int population = 0; population < 200; ++population) {
    const double size = std::exp2(population / 10 - 10);
    std::uniform_real_distribution<double> beside(-size, size);
    const Model model = triangle_at({beside(random), beside(random)}, size, random);
    const Vec2 middle = (bounding_box(model).lower + bounding_box(model).upper) / 2;
    if (middle.cwiseAbs().maxCoeff() >= 2 * diameter(model)) continue;
    EXPECT_EQ(local_origin(model, diameter(model)), Vec2(0, 0)) << population;
  }
}

// Wherever it lies its local places are no larger than a few of its sizes, and none is rounded.
TEST(Extent, LocalPlacesAreSmallAndExact) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> exponent(4, 20), side(-1, 1);
  for (int population = 0; population < 1000; ++population) {
    const double far = std::exp2(exponent(random));
    const Model model = triangle_at({far * side(random), far * side(random)}, 1, random);
    const Vec2 origin = local_origin(model, diameter(model));
    for (const Vec2& corner : model.blocks[0].shape.outer)
      for (const int axis : {0, 1}) {
        const double local = corner(axis) - origin(axis);
        EXPECT_LE(std::abs(local), 5 * diameter(model)) << population;
        if (std::abs(corner(axis)) < 10 * diameter(model)) continue;
        const long double exact = static_cast<long double>(corner(axis)) - static_cast<long double>(origin(axis));
        EXPECT_EQ(static_cast<long double>(local), exact) << population;
      }
  }
}

}  // namespace
}  // namespace dda
