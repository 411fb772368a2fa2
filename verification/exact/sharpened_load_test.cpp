// What lowered inertia takes from the waves of a load, and what sharpening gives back.
#include "verification/exact/sharpened_load.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "verification/exact/half_chain.h"

namespace exact {
namespace {

constexpr double omega = 2 * std::numbers::pi * 100;
constexpr double length = 2;  // m

BlockChain chain_of(const TimeScheme& scheme, double dt) {
  BlockChain chain;
  chain.blocks = 2;
  chain.length = length;
  chain.density = 2650;
  chain.elasticity = plane_stress(50e9, 0);
  chain.lateral_inertia = 0;
  chain.interface = cubic_edge();
  chain.interface.inertia_reduction = inertia_reduction(chain, period_error(scheme), dt);
  return chain;
}

TEST(SharpenedLoad, ShareIsThePeriodErrorWhereNothingIsCapped) {
  EXPECT_NEAR(load_sharpening(chain_of(trapezoidal(), 1e-4), 1e-4), 1.0 / 6, 1e-15);
  EXPECT_NEAR(load_sharpening(chain_of(thesis_scheme(), 1e-4), 1e-4), -1.0 / 48, 1e-15);
  BlockChain plain = chain_of(trapezoidal(), 1e-4);
  plain.interface = cubic_edge();
  EXPECT_EQ(load_sharpening(plain, 1e-4), 0);
  const double dt = 1e-3;  // c dt/L = 2.2
  const BlockChain capped = chain_of(trapezoidal(), dt);
  EXPECT_NEAR(load_sharpening(capped, dt), 0.1 * 4 * 2650 / (50e9 * dt * dt), 1e-15);
}

TEST(SharpenedLoad, LeavesWhatDoesNotBend) {
  for (const auto& load : {std::vector<double>(7, 3.0), std::vector<double>{2}}) EXPECT_EQ(sharpened(load, 0.2), load);
  const std::vector<double> ramp = sharpened({0, 1, 2, 3}, 0.2);
  EXPECT_NEAR(ramp[1], 1, 1e-15);
  EXPECT_NEAR(ramp[2], 2, 1e-15);
  const std::vector<double> peak = sharpened({0, 0, 1, 0}, 0.25);
  EXPECT_EQ(peak, (std::vector<double>{0, -0.25, 1.5, -0.25}));
}

// Amplitude at the first interface against that of short steps: too small by the share times (omega dt)^2, and by what
// is of higher order with a sharpened load.
TEST(SharpenedLoad, RestoresTheAmplitude) {
  const TimeScheme scheme = trapezoidal();
  const auto amplitude = [&](double dt) {
    return std::abs(std::complex<double>(half_chain_force(chain_of(scheme, dt), scheme, dt, omega, 1)));
  };
  const double exact = amplitude(1e-7);
  for (const double dt : {1e-4, 2e-4, 4e-4}) {
    const double theta2 = std::pow(omega * dt, 2);
    const double share = load_sharpening(chain_of(scheme, dt), dt);
    // What is left: theta^2 (omega L/c)^2 and theta^4, each times the share and a number of order one, here below 1.3.
    const double higher = 1.5 * share * theta2 * (theta2 + std::pow(omega * length / 4344, 2));
    EXPECT_NEAR(amplitude(dt) / exact - 1, -share * theta2, higher) << dt;
    EXPECT_LT(std::abs(amplitude(dt) * (1 + share * theta2) / exact - 1), higher) << dt;
    EXPECT_GT(share * theta2, 4 * higher);
  }
}

}  // namespace
}  // namespace exact
