#include "engine/cutting/opening_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dda {
namespace {

// Corners lie on the circle, and the middle of every chord within the tolerance of it.
TEST(OpeningShapes, ChordsOfACircleStayWithinTheirTolerance) {
  for (const double tolerance : {0.5, 0.1, 0.001}) {
    const Ring ring = circle({1, 2}, 3, tolerance);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      EXPECT_NEAR((ring[i] - Vec2(1, 2)).norm(), 3, 1e-12);
      const Vec2 middle = (ring[i] + ring[(i + 1) % ring.size()]) / 2;
      EXPECT_GE((middle - Vec2(1, 2)).norm(), 3 - tolerance - 1e-12);
    }
    EXPECT_GT(signed_area(ring), 0);
  }
}

// The closed areas of walls and roofs, which chords fall short of by less than tolerance times length of arc.
TEST(OpeningShapes, AreasAreThoseOfTheShapes) {
  constexpr double tolerance = 1e-5;
  constexpr double pi = std::numbers::pi;
  EXPECT_NEAR(signed_area(rectangle({0, 0}, 4, 3)), 12, 1e-12);
  EXPECT_NEAR(signed_area(arch({0, 0}, 4, 5, 2, tolerance)), 4 * 3 + pi * 4 / 2, 1e-4);
  const double radius = (4.0 + 1) / 2;  // of a roof that rises by 1 over 4
  const double angle = std::asin(2 / radius);
  EXPECT_NEAR(signed_area(arch({0, 0}, 4, 3, 1, tolerance)),
              4 * 2 + radius * radius * (angle - std::sin(2 * angle) / 2), 1e-4);
  // Half a circle, and below it the part of a lens of two circles of radius 4 down to 2 m.
  const double walls = 2 * (2 * std::sqrt(16.0 - 4) / 2 + 16 * std::asin(0.5) / 2 - 2 * 2);
  EXPECT_NEAR(signed_area(horseshoe({0, 0}, 4, 4, tolerance)), pi * 4 / 2 + walls, 1e-4);
}

TEST(OpeningShapes, StandOnTheirFoot) {
  for (const Ring& ring : {arch({1, 2}, 4, 5, 1, 0.01), horseshoe({1, 2}, 4, 5, 0.01), rectangle({1, 2}, 4, 5),
                           horseshoe({1, 2}, 4, 2, 0.01), arch({1, 2}, 4, 2, 2, 0.01)}) {
    EXPECT_FALSE(defect({ring, {}}).has_value());
    const auto [low, high] =
        std::minmax_element(ring.begin(), ring.end(), [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); });
    EXPECT_NEAR(low->y(), 2, 1e-12);
    EXPECT_NEAR(high->y(), std::abs(signed_area(ring)) > 8 ? 7 : 4, 0.02);
    const double middle =
        (std::max_element(ring.begin(), ring.end(), [](auto& a, auto& b) { return a.x() < b.x(); })->x() +
         std::min_element(ring.begin(), ring.end(), [](auto& a, auto& b) { return a.x() < b.x(); })->x()) /
        2;
    EXPECT_NEAR(middle, 1, 1e-12);
  }
}

}  // namespace
}  // namespace dda
