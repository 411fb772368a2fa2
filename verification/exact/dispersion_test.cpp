#include "verification/exact/dispersion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace exact {
namespace {

constexpr double kYoung = 50e9, kDensity = 2650;
const double kBarSpeed = std::sqrt(kYoung / kDensity);

ScalarChain scalar_chain(double length, double q, bool consistent, double inertia_factor = 1) {
  return {.young = kYoung,
          .density = kDensity,
          .length = length,
          .area = 1,
          .normal = q * kYoung / length,
          .inertia_factor = inertia_factor,
          .consistent = consistent};
}

BlockChain full_chain(const ScalarChain& scalar, double poisson) {
  BlockChain chain;
  chain.length = scalar.length;
  chain.density = scalar.density;
  chain.elasticity = plane_stress(scalar.young, poisson);
  chain.interface = {scalar.normal, 0, scalar.consistent};
  chain.inertia_factor = scalar.inertia_factor;
  return chain;
}

TEST(Dispersion, ScalarFormsAgreeWithTheWavesOfTheFullChain) {
  const double omega = 2 * std::numbers::pi * 100;
  for (const bool consistent : {false, true}) {
    for (const double length : {0.5, 2.0, 10.0}) {
      for (const TimeScheme& scheme : {thesis_scheme(), trapezoidal(), generalized_alpha(0.8)}) {
        const ScalarChain scalar = scalar_chain(length, 4, consistent, 1.3);
        const ChainWave expected = chain_wave(full_chain(scalar, 0), scheme, 1e-4, omega);
        const ChainWave found = phase_speed(scalar, scheme, 1e-4, omega);
        EXPECT_NEAR(found.speed / expected.speed, 1, 1e-14);  // round-off of extended precision, then of double
        // Without damping both are round-off: the half wave number is known to about 1e-17/X.
        EXPECT_NEAR(found.attenuation, expected.attenuation, 1e-13);
      }
    }
  }
}

// What the leading-order formula leaves of the consistent edge's speed: it must fall with the fourth power of the
// length.
double remainder_of_speed(double length, double inertia_factor) {
  const double omega = 2 * std::numbers::pi * 100, big_omega = omega * length / kBarSpeed;
  const double speed = phase_speed(scalar_chain(length, 4, true, inertia_factor), trapezoidal(), 1e-9, omega).speed;
  return std::abs(speed / kBarSpeed - 1 - (2 - inertia_factor) / 24 * big_omega * big_omega);
}

TEST(Dispersion, ConsistentEdgeHasTheKnownLeadingOrderForEveryInertiaFactor) {
  for (const double factor : {1.0, 1.5, 2.0}) {
    const double ratio = remainder_of_speed(2.0, factor) / remainder_of_speed(1.0, factor);
    EXPECT_NEAR(std::log2(ratio), 4.0, 0.1) << factor;  // next order: Omega^2 = 0.08 of it
  }
}

TEST(Dispersion, AveragedInertiaLeavesAFourthOrderErrorOfKnownSize) {
  const double omega = 2 * std::numbers::pi * 100, length = 1.0, q = 4;
  const double kappa4 = std::pow(omega * length / kBarSpeed, 4);
  const double error = phase_speed(scalar_chain(length, q, true, 2), trapezoidal(), 1e-9, omega).speed / kBarSpeed - 1;
  EXPECT_NEAR(error / (-(3 * q + 2) / (1440 * (q - 1)) * kappa4), 1.0, 0.02);  // next order: Omega^2 = 0.02 of it
}

TEST(Dispersion, CornerSpringsHaveTheKnownLeadingOrder) {
  const double omega = 2 * std::numbers::pi * 100, length = 1.0;
  for (const double q : {200.0, 2000.0}) {
    const double big_omega = omega * length / kBarSpeed;
    const double error = phase_speed(scalar_chain(length, q, false), trapezoidal(), 1e-9, omega).speed / kBarSpeed - 1;
    // Next orders: 3/8 eta_s^2, eta_s Omega^2 and Omega^4, each with a factor below 1/2.
    const double next = (std::pow(1 / q, 2) + big_omega * big_omega / q + std::pow(big_omega, 4)) / 2;
    EXPECT_NEAR(error, -1 / (2 * q) + big_omega * big_omega / 24, next);
  }
}

TEST(Dispersion, TimeSchemesHaveTheKnownLeadingOrder) {
  const double omega = 2 * std::numbers::pi * 100, dt = 1e-4, theta = omega * dt, length = 1e-3;
  const ScalarChain chain = scalar_chain(length, 1e4, true);
  const ChainWave thesis = phase_speed(chain, thesis_scheme(), dt, omega);
  EXPECT_NEAR(thesis.speed / kBarSpeed - 1, theta * theta / 96, std::pow(theta, 4));
  EXPECT_NEAR(thesis.attenuation * 4 * kBarSpeed / (omega * omega * dt), 1, theta * theta);
  const ChainWave average = phase_speed(chain, trapezoidal(), dt, omega);
  EXPECT_NEAR(average.speed / kBarSpeed - 1, -theta * theta / 12, std::pow(theta, 4));
}

// Inertia factor 2 - 2 (c dt/L)^2 makes the blocks' dispersion cancel that of the trapezoidal rule at every frequency.
TEST(Dispersion, MatchedInertiaCancelsSpaceAgainstTime) {
  const double dt = 1e-4, length = 1.0, courant = kBarSpeed * dt / length;
  const ScalarChain chain = scalar_chain(length, 4, true, 2 - 2 * courant * courant);
  const auto error = [&](double frequency) {
    return std::abs(phase_speed(chain, trapezoidal(), dt, 2 * std::numbers::pi * frequency).speed / kBarSpeed - 1);
  };
  EXPECT_NEAR(std::log2(error(200) / error(100)), 4.0, 0.1);  // no second order is left
}

// speed/c - 1 of the cubic chain in space alone, c that of free sides: a step of 1 ns adds 3e-14.
double cubic_error(double length, const PlaneElasticity& elasticity, double lateral_inertia = 0) {
  BlockChain chain = full_chain(scalar_chain(length, 0, false), 0);
  chain.elasticity = elasticity;
  chain.interface = cubic_edge();
  chain.lateral_inertia = lateral_inertia;
  const double speed = std::sqrt(bar_modulus(elasticity) / kDensity);
  return chain_wave(chain, trapezoidal(), 1e-9, 2 * std::numbers::pi * 100).speed / speed - 1;
}

TEST(Dispersion, CubicChainIsOfSixthOrderForEveryPoissonRatio) {
  for (const PlaneElasticity& elasticity :
       {plane_stress(kYoung, 0), plane_stress(kYoung, 0.25), plane_stress(kYoung, 0.45), plane_strain(kYoung, 0.25)}) {
    for (const double length : {0.5, 1.0}) {  // next order: Omega^2 = 0.08 at most; the time step adds 0.01 at 0.5 m
      EXPECT_NEAR(std::log2(cubic_error(2 * length, elasticity) / cubic_error(length, elasticity)), 6.0, 0.08)
          << length << " " << elasticity.e12;
    }
  }
}

// In plane stress Q is Young's modulus whatever Poisson's ratio: so is the wave without lateral inertia.
TEST(Dispersion, PoissonRatioDoesNotShowInTheCubicChainWithoutLateralInertia) {
  for (const double poisson : {0.1, 0.25, 0.45}) {
    EXPECT_NEAR(cubic_error(4, plane_stress(kYoung, poisson)), cubic_error(4, plane_stress(kYoung, 0)), 1e-15)
        << poisson;  // round-off of double
  }
}

// Love's rod: the sides' kinetic energy rho (nu h)^2/12 w''^2/2 lowers the speed by (nu k h)^2/24 to leading order, k =
// omega/c the wave number, h = L here and nu = e12/e11 the ratio of free sides.
TEST(Dispersion, LateralInertiaGivesTheCubicChainLovesDispersion) {
  for (const double poisson : {0.1, 0.25}) {
    for (const PlaneElasticity& elasticity : {plane_stress(kYoung, poisson), plane_strain(kYoung, poisson)}) {
      const double length = 1.0, omega = 2 * std::numbers::pi * 100, ratio = elasticity.e12 / elasticity.e11;
      const double big_omega2 = std::pow(omega * length, 2) * kDensity / bar_modulus(elasticity);
      const double expected = -ratio * ratio * big_omega2 / 24;
      EXPECT_NEAR(cubic_error(length, elasticity, 1) / expected, 1.0, big_omega2) << elasticity.e12;  // next order
    }
  }
}

// Speed of a bar whose sides have inertia rho h^3/12 and resist with `lateral` (Pa) to leaving the strains of free
// sides: sigma = Q w' - nu rho h^2/12 ey'' with lateral (ey + nu w') = -rho h^2/12 ey''.
double lateral_bar_speed(const PlaneElasticity& elasticity, double lateral, double height, double omega) {
  const double inertia = kDensity * height * height / 12 * omega * omega, ratio = elasticity.e12 / elasticity.e11;
  const double modulus = bar_modulus(elasticity) - ratio * ratio * lateral * inertia / (lateral - inertia);
  return std::sqrt(modulus / kDensity);
}

// The README's limits of flat blocks: e11 resists, and under the cubic law in series with the Q/5 of strains that move
// no centroid. At 1 kHz their speeds differ by 4.6e-4. Blocks of a hundredth of the height leave (k L)^2/24 = 1e-5 of
// the speed, the cubic (k L)^2 = 2e-4 of that difference.
TEST(Dispersion, FlatBlocksHaveTheirOwnLateralDispersion) {
  const PlaneElasticity elasticity = plane_stress(kYoung, 0.25);
  const double omega = 2 * std::numbers::pi * 1000, length = 0.01, modulus = bar_modulus(elasticity);
  BlockChain chain = full_chain(scalar_chain(length, 4, true), 0.25);
  const double rigid = lateral_bar_speed(elasticity, elasticity.e11, chain.height, omega);
  EXPECT_NEAR(chain_wave(chain, trapezoidal(), 1e-9, omega).speed / rigid, 1, 2e-5);
  chain.interface = cubic_edge();
  const double series = 1 / (1 / elasticity.e11 + 5 * 0.25 * 0.25 / modulus);
  const double soft = lateral_bar_speed(elasticity, series, chain.height, omega);
  EXPECT_NEAR(chain_wave(chain, trapezoidal(), 1e-9, omega).speed / soft, 1, 1e-7);
}

TEST(Dispersion, InertiaReductionCancelsTheTimeSchemesError) {
  const double dt = 1e-4, omega = 2 * std::numbers::pi * 100, theta = omega * dt;
  for (const TimeScheme& scheme : {trapezoidal(), hht(0.1), generalized_alpha(0.8)}) {
    BlockChain chain = full_chain(scalar_chain(1.0, 0, false), 0);
    chain.interface = cubic_edge();
    const double plain = chain_wave(chain, scheme, dt, omega).speed / kBarSpeed - 1;
    EXPECT_NEAR(plain / (-period_error(scheme) * theta * theta / 2), 1.0, 0.01);  // next order: theta^2 = 0.004
    chain.interface.inertia_reduction = inertia_reduction(chain, period_error(scheme), dt);
    // Left is of fourth order in the time step alone: period_error theta^2 times theta^2 and a number below one.
    EXPECT_LT(std::abs(chain_wave(chain, scheme, dt, omega).speed / kBarSpeed - 1), theta * theta * std::abs(plain));
  }
}

// Shear springs k_s at the corners hold the lateral strain: E grows to E1 (1 - nu^2/(1 + 2 (k_s h/(L E1))
// sin^2(kappa/2))) with E1 = E/(1 - nu^2), up to E1 itself.
TEST(Dispersion, ShearSpringsStiffenTheBarTowardsTheConfinedSpeed) {
  const double poisson = 0.25, omega = 2 * std::numbers::pi * 100, height = 1e-3;  // thin: without lateral inertia
  ScalarChain scalar = scalar_chain(1.0, 50, false);
  scalar.area = height;
  scalar.normal *= height;
  BlockChain chain = full_chain(scalar, poisson);
  chain.height = height;
  const double confined = plane_stress(kYoung, poisson).e11;
  for (const double spring : {1e3 * kYoung, 1e5 * kYoung, 1e7 * kYoung}) {
    chain.interface.tangential_half = 2 * spring;
    const double speed = chain_wave(chain, trapezoidal(), 1e-9, omega).speed;
    const double sine = std::sin(omega * scalar.length / speed / 2);
    const double hold = 2 * spring * height / (scalar.length * confined) * sine * sine;
    scalar.young = confined * (1 - poisson * poisson / (1 + hold));
    // Rayleigh's lateral inertia, nu^2 (kappa h/L)^2/24, is 5e-11 of the speed.
    EXPECT_NEAR(speed / phase_speed(scalar, trapezoidal(), 1e-9, omega).speed, 1, 1e-9) << spring;
  }
  EXPECT_NEAR(scalar.young / confined, 1, 0.01);  // the last spring confines
}

}  // namespace
}  // namespace exact
