#include "verification/exact/rocking.h"

#include <gtest/gtest.h>

#include <cmath>

namespace exact {
namespace {

constexpr double gravity = 9.81;

// The full equation stepped by Runge and Kutta's method, with the last step cut where the block stands upright.
double period_by_steps(const RockingBlock& block, double theta0, int steps) {
  const double alpha = block.slenderness_angle();
  const double p = rocking_frequency(block, gravity);
  const auto acceleration = [&](double theta) { return -p * p * std::sin(alpha - theta); };
  const double dt = housner_period(block, gravity, theta0) / 4 / steps;
  double theta = theta0;
  double speed = 0;
  double time = 0;
  while (true) {
    const double k1 = acceleration(theta);
    const double k2 = acceleration(theta + dt / 2 * speed);
    const double k3 = acceleration(theta + dt / 2 * speed + dt * dt / 4 * k1);
    const double k4 = acceleration(theta + dt * speed + dt * dt / 2 * k2);
    const double next = theta + dt * speed + dt * dt / 6 * (k1 + k2 + k3);
    if (next <= 0) break;
    theta = next;
    speed += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    time += dt;
  }
  // The rest of the way is shorter than a step: a parabola, whose error is of the third order in it.
  const double a = acceleration(0);
  return 4 * (time + (std::sqrt(speed * speed - 2 * a * theta) + speed) / -a);
}

TEST(Rocking, PeriodIsThatOfTheFullEquation) {
  for (const double slenderness : {1.5, 4.0, 10.0}) {
    for (const double share : {0.1, 0.5, 0.9}) {
      const RockingBlock block{1, slenderness};
      const double theta0 = share * block.slenderness_angle();
      const double period = rocking_period(block, gravity, theta0);
      EXPECT_NEAR(period_by_steps(block, theta0, 4000), period, 1e-9 * period) << slenderness << ' ' << share;
    }
  }
}

// What linearising costs: nothing for slender blocks, 1.3 % at height/width = 2 and a fifth of the largest tilt.
TEST(Rocking, LinearisedPeriodIsShortByTheSquareOfTheSlendernessAngle) {
  const auto cost = [](double slenderness, double share) {
    const RockingBlock block{1, slenderness};
    const double theta0 = share * block.slenderness_angle();
    return rocking_period(block, gravity, theta0) / housner_period(block, gravity, theta0) - 1;
  };
  EXPECT_NEAR(cost(2, 0.2), 0.0126, 5e-5);
  EXPECT_NEAR(cost(4, 0.2), 0.00349, 5e-6);
  EXPECT_NEAR(cost(8, 0.8), 0.000176, 5e-7);
  for (const double share : {0.2, 0.5, 0.8}) {
    // alpha^2 shrinks by 4 but for alpha^4.
    EXPECT_NEAR(cost(40, share) / cost(80, share), 4, 0.01) << share;
  }
}

TEST(Rocking, SpeedAndAmplitudeAreEachOthersInverse) {
  const RockingBlock block{0.5, 2};
  for (const double theta0 : {0.02, 0.1, 0.2}) {
    const double speed = rocking_speed(block, gravity, theta0, 0);
    EXPECT_NEAR(rocking_amplitude(block, gravity, speed), theta0, 1e-14);
    // Kinetic energy (4/3) m R^2 speed^2/2 is the weight times the fall of the centroid.
    const double alpha = block.slenderness_angle();
    const double fall = block.radius() * (std::cos(alpha - theta0) - std::cos(alpha));
    EXPECT_NEAR(4.0 / 6 * std::pow(block.radius() * speed, 2), gravity * fall, 1e-14);
  }
}

// Angular momentum about the landing corner, from the velocity of the centroid and the spin.
TEST(Rocking, ImpactKeepsAngularMomentumAboutTheLandingCorner) {
  for (const RockingBlock& block : {RockingBlock{1, 1}, RockingBlock{1, 3}, RockingBlock{2, 1}}) {
    const double inertia = (block.width * block.width + block.height * block.height) / 12;
    const auto about_landing_corner = [&](double vertical_velocity) {
      return inertia + block.height / 2 * block.height / 2 + block.width / 2 * vertical_velocity;
    };
    const double before = about_landing_corner(-block.width / 2);
    const double after = about_landing_corner(block.width / 2);
    EXPECT_NEAR(rocking_impact_ratio(block), before / after, 1e-15);
  }
}

TEST(Rocking, FloorThatMovesTiltsTheBlockFromTheUpliftOn) {
  const RockingBlock block{0.5, 2};
  const double limit = uplift_acceleration(block, gravity);
  EXPECT_EQ(limit, gravity / 4);
  const auto ramp = [&](double t) { return 2 * limit * t; };  // uplift at t = 0.5
  EXPECT_EQ(tilt_on_moving_floor(block, gravity, ramp, 0.49), 0);
  // At first theta'' = p^2 cos(alpha) (a/g - tan alpha), linear in time: a cube.
  const double p = rocking_frequency(block, gravity);
  const double cube = p * p * std::cos(block.slenderness_angle()) * 2 * limit / gravity * std::pow(0.02, 3) / 6;
  EXPECT_NEAR(tilt_on_moving_floor(block, gravity, ramp, 0.52), cube, 1e-3 * cube);
  const double fine = tilt_on_moving_floor(block, gravity, ramp, 0.8, 8000);
  EXPECT_NEAR(tilt_on_moving_floor(block, gravity, ramp, 0.8, 4000), fine, 1e-7 * fine);
}

}  // namespace
}  // namespace exact
