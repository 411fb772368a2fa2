#include "verification/exact/wave_speeds.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <numbers>
#include <vector>

#include "verification/exact/block_chain.h"
#include "verification/exact/dense_newmark.h"
#include "verification/exact/finite_chain.h"

namespace exact {
namespace {

constexpr double kRoundOff = 1e-12;

TEST(WaveSpeeds, MeetEachOtherWhereTheyMust) {
  const double young = 50e9, density = 2650;
  EXPECT_NEAR(bar_speed(young, density), 4343.72, 0.005);  // printed in the thesis
  EXPECT_DOUBLE_EQ(p_speed_plane_stress(young, 0, density), bar_speed(young, density));
  for (const double nu : {0.0, 0.1, 0.25, 0.4}) {
    const double lambda = young * nu / ((1 + nu) * (1 - 2 * nu)), shear = young / (2 * (1 + nu));
    EXPECT_NEAR(p_speed_plane_strain(young, nu, density) / std::sqrt((lambda + 2 * shear) / density), 1, kRoundOff);
    EXPECT_NEAR(s_speed(young, nu, density) / std::sqrt(shear / density), 1, kRoundOff);
    EXPECT_NEAR(p_speed_plane_stress(young, nu, density) / std::sqrt(plane_stress(young, nu).e11 / density), 1,
                kRoundOff);
    EXPECT_NEAR(p_speed_plane_strain(young, nu, density) / std::sqrt(plane_strain(young, nu).e11 / density), 1,
                kRoundOff);
  }
}

TEST(WaveSpeeds, LateralRatiosFollowFromTheElasticity) {
  const PlaneElasticity stress = plane_stress(1, 0.3), strain = plane_strain(1, 0.3);
  EXPECT_NEAR(lateral_ratio_plane_stress(0.3), stress.e12 / stress.e11, kRoundOff);
  EXPECT_NEAR(lateral_ratio_plane_strain(0.3), strain.e12 / strain.e11, kRoundOff);
}

// A long smooth push reflected by the end of a fine chain: the stress near the end is (1 + R) times the arriving one.
TEST(WaveSpeeds, StressReflectionIsTheLimitOfTheChain) {
  BlockChain chain;
  chain.blocks = 200;
  chain.length = 0.25;
  chain.density = 2650;
  chain.elasticity = plane_stress(50e9, 0);
  chain.interface = consistent_edge(4 * 50e9 / chain.length, 0);
  const double dt = 4e-5, impedance = chain.density * bar_speed(50e9, chain.density);
  const auto push = [](double t) { return std::exp(-std::pow((t - 0.012) / 0.004, 2)); };
  std::vector<double> load;
  for (int i = 0; i < 800; ++i) load.push_back(push(i * dt));
  for (const double ratio : {0.0, 0.5, 1.0, 3.0}) {
    chain.end_impedance = ratio * impedance;
    const auto at_end = finite_chain_response(chain, trapezoidal(), dt, load, {{ChainQuantity::block_stress, 199}})[0];
    const int arrival = 588;  // 0.012 s + 50 m/c
    // The block's centre is 0.125 m before the end, 0.7 % of the push's length: second order for the peak's height.
    EXPECT_NEAR(-at_end[arrival], 1 + stress_reflection(ratio), 2e-3) << ratio;
  }
}

TEST(WaveSpeeds, PulseEnergyIsTheWorkOfTheForce) {
  const double force = 1e6, frequency = 100, impedance = 2650 * 4343.72;
  double work = 0;
  for (int i = 0; i < 1000; ++i) {
    work += std::pow(force * std::sin(2 * std::numbers::pi * (i + 0.5) / 1000), 2) / impedance / (1000 * frequency);
  }
  EXPECT_NEAR(sine_pulse_energy(force, frequency, impedance) / work, 1, kRoundOff);
}

// Column of blocks with unknowns (u, e) from its potential energy, solved densely.
TEST(WaveSpeeds, ColumnAndStackFollowFromTheBlocksPotential) {
  const double young = 3, density = 2, gravity = 5, length = 0.5, area = 0.7, stiffness = 11;
  const int n = 6;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(2 * n), push = weight;
  for (int i = 0; i < n; ++i) {
    matrix(2 * i + 1, 2 * i + 1) += young * area * length;
    weight[2 * i] = -density * gravity * area * length;
    Eigen::VectorXd gap = Eigen::VectorXd::Zero(2 * n);
    gap[2 * i] = 1;
    gap[2 * i + 1] = -length / 2;
    if (i > 0) gap[2 * i - 2] = -1, gap[2 * i - 1] = -length / 2;
    matrix += stiffness * gap * gap.transpose();
  }
  push[2 * n - 2] = -1;
  push[2 * n - 1] = -length / 2;
  const Eigen::VectorXd rest = matrix.partialPivLu().solve(weight), squeezed = matrix.partialPivLu().solve(push);
  const auto top = [&](const Eigen::VectorXd& u) { return u[2 * n - 2] + length / 2 * u[2 * n - 1]; };
  EXPECT_NEAR(-top(rest), block_column_shortening(young, density, gravity, length, area, n, stiffness, true),
              kRoundOff);
  for (int i = 0; i < n; ++i) {
    const double pressure = self_weight_pressure(density, gravity, n * length, (i + 0.5) * length);
    EXPECT_NEAR(-young * rest[2 * i + 1], pressure, kRoundOff);
  }
  EXPECT_NEAR(-top(squeezed), n * length / (area * stack_modulus(young, length, area, stiffness)), kRoundOff);
  const double without_base = -top(squeezed) - 1 / stiffness;
  EXPECT_NEAR(without_base, n * length / (area * stack_modulus(young, length, area, stiffness, n)), kRoundOff);
  EXPECT_NEAR(block_column_shortening(young, density, gravity, length, area, n, stiffness, false),
              -top(rest) - n * density * gravity * area * length / stiffness, kRoundOff);
}

Eigen::MatrixXd fall(const TimeScheme& scheme, double gravity, double dt, int steps) {
  const Eigen::MatrixXd one = Eigen::MatrixXd::Ones(1, 1), none = Eigen::MatrixXd::Zero(1, 1);
  const auto weight = [&](int) -> Eigen::VectorXd { return Eigen::VectorXd::Constant(1, gravity); };
  return dense_newmark({one, none, none}, scheme, dt, steps, weight, one);
}

TEST(WaveSpeeds, FreeFallIsExactForEveryScheme) {
  for (const TimeScheme& scheme : {thesis_scheme(), trapezoidal(), hht(0.1), generalized_alpha(0.8)}) {
    const Eigen::MatrixXd drop = fall(scheme, 9.81, 0.01, 100);
    EXPECT_NEAR(drop(0, 100), free_fall(9.81, 1.0), kRoundOff);
    EXPECT_NEAR(drop(0, 37), free_fall(9.81, 0.37), kRoundOff);
  }
}

TEST(WaveSpeeds, FallWithCarriedVelocityReachesItsTerminalVelocity) {
  const double gravity = 9.81, dt = 0.01, k = 0.8;
  TimeScheme scheme = thesis_scheme();
  scheme.carried_velocity = k;
  const Eigen::MatrixXd drop = fall(scheme, gravity, dt, 200);
  EXPECT_NEAR((drop(0, 200) - drop(0, 199)) / dt, terminal_velocity(gravity, dt, k).mean, kRoundOff);
  // Step 3 starts with k times the velocity at the end of step 2.
  const double third = k * velocity_after_steps(gravity, dt, k, 2) * dt + gravity * dt * dt / 2;
  EXPECT_NEAR(drop(0, 3) - drop(0, 2), third, kRoundOff);
  EXPECT_NEAR(velocity_after_steps(gravity, dt, k, 300), terminal_velocity(gravity, dt, k).end, kRoundOff);
  EXPECT_NEAR(terminal_velocity(gravity, dt, k).carried, k * gravity * dt / (1 - k), kRoundOff);
}

TEST(WaveSpeeds, ThesisOscillatorHasTheExactFactorAndPhase) {
  const double theta = 0.3, dt = 0.1, omega = theta / dt;
  const std::vector<double> history = free_oscillation(thesis_scheme(), omega, dt, 40);
  // u_n = factor^n (cos n phase + s sin n phase); s from step 1, every later step must then follow.
  const double factor = thesis_step_factor(theta), phase = thesis_step_phase(theta);
  const double s = (history[1] / factor - std::cos(phase)) / std::sin(phase);
  for (int n = 2; n <= 40; ++n) {
    const double expected = std::pow(factor, n) * (std::cos(n * phase) + s * std::sin(n * phase));
    EXPECT_NEAR(history[static_cast<std::size_t>(n)], expected, kRoundOff) << n;
  }
  EXPECT_NEAR(std::log(std::pow(factor, 40) / thesis_decay(omega, dt, 40 * dt)), 40 * std::pow(theta, 4) / 16,
              40 * std::pow(theta, 6) / 48 * 1.01);
}

}  // namespace
}  // namespace exact
