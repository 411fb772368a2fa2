#include "verification/exact/collision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace exact {
namespace {

// The equation itself in short steps (velocity Verlet with the force of both, which ends the contact when it pulls).
double stepped_restitution(double spring, double dashpot, double mass) {
  const double dt = 1e-6;
  double depth = 0;
  double velocity = 1;
  for (int i = 0; i < 100000000; ++i) {
    const double middle = depth + velocity * dt / 2;
    const double force = spring * middle + dashpot * velocity;
    if (force < 0) return -velocity;
    // Implicit in the dashpot, explicit in the spring.
    const double next =
        (velocity * (1 - dashpot * dt / (2 * mass)) - spring * middle * dt / mass) / (1 + dashpot * dt / (2 * mass));
    depth += dt * (velocity + next) / 2;
    velocity = next;
  }
  return 2;
}

TEST(Collision, DashpotRestitutionAgreesWithSteppingTheEquation) {
  for (const double ratio : {0.0, 0.1, 0.6, 0.9, 1.5, 4.0})
    EXPECT_NEAR(dashpot_restitution(2, ratio * 2 * std::sqrt(2.0 * 0.5), 0.5),
                stepped_restitution(2, ratio * 2 * std::sqrt(2.0 * 0.5), 0.5), 1e-5)
        << ratio;
}

TEST(Collision, DashpotRestitutionIsSmoothAtCriticalDamping) {
  EXPECT_DOUBLE_EQ(dashpot_restitution(1, 2, 1), std::exp(-2.0));
  EXPECT_NEAR(dashpot_restitution(1, 2 - 1e-7, 1), std::exp(-2.0), 1e-6);
  EXPECT_NEAR(dashpot_restitution(1, 2 + 1e-7, 1), std::exp(-2.0), 1e-6);
}

TEST(Collision, CommonVelocityKeepsTheMomentum) {
  EXPECT_DOUBLE_EQ(common_velocity(2, 3, 4, 0), 1);
  EXPECT_DOUBLE_EQ(common_velocity(2, 3, 4, -1.5), 0);
}

}  // namespace
}  // namespace exact
