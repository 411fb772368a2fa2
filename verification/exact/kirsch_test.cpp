#include "verification/exact/kirsch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace exact {
namespace {

constexpr double pi = std::numbers::pi;

TEST(Kirsch, WallIsFreeAndConcentratesThreeTimesLessOnce) {
  for (const double angle : {0.0, 0.4, 1.1, 2.0}) {
    EXPECT_NEAR(kirsch(3, -2, 1, angle).radial, 0, 1e-15);
    EXPECT_NEAR(kirsch(3, -2, 1, angle).shear, 0, 1e-15);
  }
  EXPECT_NEAR(kirsch(3, -2, 1, pi / 2).hoop, 3 * 3.0 + 2, 1e-14);
  EXPECT_NEAR(kirsch(3, -2, 1, 0).hoop, 3 * -2.0 - 3, 1e-14);
}

TEST(Kirsch, IsTheFarStressFarAway) {
  EXPECT_NEAR(kirsch(3, -2, 0, 0).radial, 3, 1e-15);
  EXPECT_NEAR(kirsch(3, -2, 0, pi / 2).radial, -2, 1e-15);
  EXPECT_NEAR(kirsch(3, -2, 0, pi / 4).shear, -2.5, 1e-15);  // planes at 45 degrees
}

// Equilibrium in polar coordinates, and a mean stress that is harmonic (compatibility), by central differences.
TEST(Kirsch, IsInEquilibriumAndCompatible) {
  const double h = 1e-3;
  const auto at = [](double r, double angle) { return kirsch(3, -2, 1 / r, angle); };
  for (const double r : {1.2, 2.0, 4.0})
    for (const double angle : {0.3, 1.0, 2.5}) {
      const PolarStress s = at(r, angle);
      const auto slope = [&](double PolarStress::*part) {
        return (at(r + h, angle).*part - at(r - h, angle).*part) / (2 * h);
      };
      const auto turn = [&](double PolarStress::*part) {
        return (at(r, angle + h).*part - at(r, angle - h).*part) / (2 * h);
      };
      EXPECT_NEAR(slope(&PolarStress::radial) + turn(&PolarStress::shear) / r + (s.radial - s.hoop) / r, 0, 1e-4);
      EXPECT_NEAR(slope(&PolarStress::shear) + turn(&PolarStress::hoop) / r + 2 * s.shear / r, 0, 1e-4);
      const auto mean = [&](double radius, double a) { return at(radius, a).radial + at(radius, a).hoop; };
      const double laplace = (mean(r + h, angle) - 2 * mean(r, angle) + mean(r - h, angle)) / (h * h) +
                             (mean(r + h, angle) - mean(r - h, angle)) / (2 * h * r) +
                             (mean(r, angle + h) - 2 * mean(r, angle) + mean(r, angle - h)) / (h * h * r * r);
      EXPECT_NEAR(laplace, 0, 1e-4);
    }
}

}  // namespace
}  // namespace exact
