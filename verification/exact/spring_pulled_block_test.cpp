#include "verification/exact/spring_pulled_block.h"

#include <gtest/gtest.h>

#include <cmath>

namespace exact {
namespace {

constexpr double pull = 0.1, omega = 7, friction = 3;

// The equation itself in short steps (semi-implicit Euler), friction holding what it can.
double stepped_position(double velocity, double end, int steps) {
  const double dt = end / steps;
  double position = 0;
  for (int i = 0; i < steps; ++i) {
    const double spring = friction + omega * omega * (pull * (i + 0.5) * dt - position - velocity * dt / 2);
    const double free = velocity + dt * spring;
    const double held = std::copysign(std::max(0.0, std::abs(free) - dt * friction), free);
    position += dt * (velocity + held) / 2;
    velocity = held;
  }
  return position;
}

TEST(SpringPulledBlock, AgreesWithSteppingTheEquation) {
  const SpringPulledBlock block(pull, 0.35, omega);
  EXPECT_LT(block.shortfall(), 2 * friction);
  for (const double end : {0.9 * block.stops_at(), (block.stops_at() + block.slips_again_at()) / 2, 2.0})
    EXPECT_NEAR(block.position(end), stepped_position(0.35, end, 2000000), 1e-7) << end;
}

TEST(SpringPulledBlock, IsSmoothWhereItStopsAndStarts) {
  const SpringPulledBlock block(pull, 0.35, omega);
  for (const double t : {block.stops_at(), block.slips_again_at()}) {
    EXPECT_NEAR(block.velocity(t - 1e-9), block.velocity(t + 1e-9), 1e-7);
    EXPECT_NEAR(block.position(t - 1e-9), block.position(t + 1e-9), 1e-9);
  }
}

}  // namespace
}  // namespace exact
