#include "verification/exact/plane_failure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "verification/exact/roof_prism.h"

namespace exact {
namespace {

TEST(PlaneFailure, SafetyIsOneAtTheLimits) {
  const PlaneFailure block{0.6, 8, 2e5};
  EXPECT_NEAR(block.safety(0, 0.6), 1, 1e-15);
  EXPECT_NEAR(block.safety(block.limiting_cohesion(0.3), 0.3), 1, 1e-15);
  EXPECT_NEAR(block.safety(5e3, block.limiting_friction(5e3)), 1, 1e-15);
  EXPECT_NEAR(block.limiting_cohesion(0) * block.area, block.weight * std::sin(0.6), 1e-9);
}

// Equilibrium of the prism and of half the roof, written out.
TEST(RoofPrism, BalancesAtConstantThrust) {
  const RoofPrism prism{0.4, 0.7};
  const double weight = held_weight_at_constant_thrust(prism, 1e5);
  const double normal = 1e5 * std::cos(prism.friction) / std::cos(prism.friction - prism.alpha);
  const double shear = normal * std::tan(prism.friction);
  EXPECT_NEAR(normal * std::cos(prism.alpha) + shear * std::sin(prism.alpha), 1e5, 1e-9);
  EXPECT_NEAR(2 * (shear * std::cos(prism.alpha) - normal * std::sin(prism.alpha)), weight, 1e-9);
}

TEST(RoofPrism, BalancesBetweenFixedAbutments) {
  const RoofPrism prism{0.4, 0.7};
  constexpr double ratio = 0.4;
  constexpr double stiffness = 1e9;
  constexpr double thrust = 1e5;
  double sinking = 0;
  double weight = 0;
  const double s = std::sin(prism.alpha);
  const double c = std::cos(prism.alpha);
  while (true) {  // sink until a plane slips
    const double normal = thrust * c - stiffness * sinking * s;
    const double shear = thrust * s + ratio * stiffness * sinking * c;
    if (shear > normal * std::tan(prism.friction)) break;
    weight = 2 * (shear * c - normal * s);
    sinking += 1e-10;
  }
  EXPECT_NEAR(held_weight_between_fixed_abutments(prism, thrust, ratio), weight, 1e-5 * weight);
}

// Planes that stand upright keep their normal force, whatever the springs.
TEST(RoofPrism, UprightPlanes) {
  EXPECT_NEAR(held_weight_between_fixed_abutments({0, 0.5}, 3, 0.4), 6 * std::tan(0.5), 1e-14);
  EXPECT_NEAR(held_weight_at_constant_thrust({0, 0.5}, 3), 6 * std::tan(0.5), 1e-14);
}

}  // namespace
}  // namespace exact
