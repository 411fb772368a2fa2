#include "verification/exact/block_on_incline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace exact {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double gravity = 9.81;

InclineMotion motion(double foot, double slope, double friction) {
  return initial_motion({foot, 1, slope * degree, friction * degree}, gravity);
}

void expect(double foot, double slope, double friction, bool slides, bool topples) {
  const InclineMotion got = motion(foot, slope, friction);
  EXPECT_EQ(got.slides(), slides) << foot << ' ' << slope << ' ' << friction;
  EXPECT_EQ(got.topples(), topples) << foot << ' ' << slope << ' ' << friction;
}

TEST(BlockOnIncline, FourRegions) {
  // tan 26.565 deg = 1/2.
  expect(0.5, 20, 25, false, false);
  expect(0.5, 26.5, 26.51, false, false);
  expect(0.5, 20, 19.9, true, false);
  expect(0.5, 40, 26.5, true, false);  // tan a > b/h, but its friction cannot tip it
  expect(0.5, 40, 26.7, true, true);
  expect(0.5, 30, 30.1, false, true);
  expect(0.5, 30, 29.9, false, true);  // f < a, but turning takes load off the shear force
}

// Whatever the region, the accelerations obey Newton and Euler with contact forces that friction allows.
TEST(BlockOnIncline, MotionObeysNewtonEulerAndCoulomb) {
  int slide = 0;
  int topple = 0;
  int both = 0;
  for (const double b : {0.2, 0.5, 1.0, 1.5}) {
    for (double slope = 1; slope < 70; slope += 1.7) {
      for (double friction = 0.5; friction < 53; friction += 1.3) {
        const InclineMotion got = motion(b, slope, friction);
        const double x = got.sliding + got.toppling / 2;  // acceleration of the centroid; height is 1
        const double normal = gravity * std::cos(slope * degree) + got.toppling * b / 2;
        const double shear = gravity * std::sin(slope * degree) - x;
        const double place = (shear / 2 - got.toppling * (b * b + 1) / 12) / normal;  // of the normal force, downhill
        const double mu = std::tan(friction * degree);
        ASSERT_GT(normal, 0);
        ASSERT_GE(got.sliding, 0);
        ASSERT_GE(got.toppling, 0);
        ASSERT_LE(shear, mu * normal * (1 + 1e-12)) << b << ' ' << slope << ' ' << friction;
        ASSERT_LE(place, b / 2 * (1 + 1e-12)) << b << ' ' << slope << ' ' << friction;
        ASSERT_TRUE(!got.slides() || std::abs(shear - mu * normal) <= 1e-12 * normal);
        ASSERT_TRUE(!got.topples() || std::abs(place - b / 2) <= 1e-12);
        slide += got.slides() && !got.topples() ? 1 : 0;
        topple += got.topples() && !got.slides() ? 1 : 0;
        both += got.slides() && got.topples() ? 1 : 0;
      }
    }
  }
  EXPECT_GT(slide, 100);
  EXPECT_GT(topple, 100);
  EXPECT_GT(both, 100);
}

TEST(BlockOnIncline, MotionIsContinuousAcrossBoundaries) {
  const InclineMotion below = motion(0.5, 40, std::atan(0.5) / degree - 1e-7);
  const InclineMotion above = motion(0.5, 40, std::atan(0.5) / degree + 1e-7);
  EXPECT_NEAR(below.sliding, above.sliding, 1e-6);
  EXPECT_LT(above.toppling, 1e-6);
  // The friction needed to topple without sliding, by bisection: sliding sets in from zero.
  double low = 27;
  double high = 40;
  while (high - low > 1e-9) (motion(0.5, 40, (low + high) / 2).slides() ? low : high) = (low + high) / 2;
  EXPECT_LT(motion(0.5, 40, low).sliding, 1e-6);
  EXPECT_NEAR(motion(0.5, 40, low).toppling, motion(0.5, 40, high).toppling, 1e-6);
}

TEST(BlockOnIncline, KnowsWhatIsNearABoundary) {
  const auto clear = [](double slope, double friction) {
    return is_clear_of_boundaries({0.5, 1, slope * degree, friction * degree}, 0.1 * degree);
  };
  EXPECT_TRUE(clear(20, 20.11));
  EXPECT_FALSE(clear(20, 20.09));
  EXPECT_FALSE(clear(20, 19.91));
  EXPECT_FALSE(clear(26.5, 40));
  EXPECT_TRUE(clear(26.4, 40));
}

}  // namespace
}  // namespace exact
