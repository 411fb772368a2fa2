#include "verification/exact/time_scheme.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

namespace exact {
namespace {

constexpr double kRoundOff = 1e-13;

std::vector<TimeScheme> all_schemes() {
  TimeScheme damped = thesis_scheme();
  damped.carried_velocity = 0.9;
  return {thesis_scheme(), trapezoidal(), hht(0.1), generalized_alpha(0.8), damped};
}

TEST(TimeScheme, FactoriesMeetTheirDefiningLimits) {
  const TimeScheme no_damping = generalized_alpha(1.0);
  EXPECT_DOUBLE_EQ(no_damping.beta, 0.25);
  EXPECT_DOUBLE_EQ(no_damping.gamma, 0.5);
  EXPECT_DOUBLE_EQ(hht(0.0).beta, trapezoidal().beta);
  for (const double rho : {0.0, 0.3, 0.8, 1.0}) {
    // Up to a triple root at infinity, split by theta^-2: rho is reached to theta^(-2/3) = 1e-4.
    EXPECT_NEAR(spectral_radius(generalized_alpha(rho), 1e6), rho, 1e-3) << rho;
  }
}

TEST(TimeScheme, ThesisSchemeDampsByTheExactFactorAndItsExponentialLimit) {
  for (const double theta : {0.01, 0.1, 0.5, 2.0}) {
    EXPECT_NEAR(spectral_radius(thesis_scheme(), theta), 1 / std::sqrt(1 + theta * theta / 2), kRoundOff);
  }
  const double theta = 0.02;
  const int steps = 5000;
  const double decay = std::pow(spectral_radius(thesis_scheme(), theta), steps);
  // ln(1 + x)/2 = x/2 - x^2/4 + ...: the exponential is short of the exact factor by steps theta^4/16 in the exponent.
  EXPECT_NEAR(std::log(decay) + steps * theta * theta / 4, steps * std::pow(theta, 4) / 16, steps * std::pow(theta, 6));
}

TEST(TimeScheme, TrapezoidalKeepsTheAmplitude) {
  for (const double theta : {0.01, 0.1, 1.0, 10.0}) {
    EXPECT_NEAR(spectral_radius(trapezoidal(), theta), 1.0, kRoundOff);
  }
}

// Global error at a time that is no multiple of the period, halving the step: the order must come from both sides.
TEST(TimeScheme, ConvergesWithItsOrder) {
  const double omega = 2 * std::numbers::pi, end = 1.37;
  const auto error = [&](const TimeScheme& scheme, int steps) {
    return std::abs(free_oscillation(scheme, omega, end / steps, steps).back() - std::cos(omega * end));
  };
  for (const auto& [scheme, order] : {std::pair{thesis_scheme(), 1.0}, std::pair{trapezoidal(), 2.0},
                                      std::pair{hht(0.1), 2.0}, std::pair{generalized_alpha(0.8), 2.0}}) {
    const double observed = std::log2(error(scheme, 4000) / error(scheme, 8000));
    EXPECT_NEAR(observed, order, 0.02) << scheme.beta;  // next order's share: about omega dt = 0.002
  }
}

struct Oscillator {
  double mass, damping, stiffness;
};

// Displacements of the recursion as written in the header, for an oscillator under `load`.
std::vector<double> step_through(const TimeScheme& s, const Oscillator& o, double dt, const std::vector<double>& load) {
  double u = 0, v = 0, a = load[0] / o.mass;
  std::vector<double> history{0};
  for (std::size_t n = 0; n + 1 < load.size(); ++n) {
    const double u_free = u + dt * s.carried_velocity * v + dt * dt * (0.5 - s.beta) * a;
    const double v_free = s.carried_velocity * v + dt * (1 - s.gamma) * a;
    const double known = s.alpha_m * o.mass * a + s.alpha_f * (o.damping * v + o.stiffness * u) +
                         (1 - s.alpha_f) * (o.damping * v_free + o.stiffness * u_free);
    const double force = (1 - s.alpha_f) * load[n + 1] + s.alpha_f * load[n];
    a = (force - known) /
        ((1 - s.alpha_m) * o.mass + (1 - s.alpha_f) * (s.gamma * dt * o.damping + s.beta * dt * dt * o.stiffness));
    u = u_free + s.beta * dt * dt * a;
    v = v_free + s.gamma * dt * a;
    history.push_back(u);
  }
  return history;
}

Complex transform(const std::vector<double>& history, Complex z) {
  Complex sum = 0, power = 1;
  for (const double value : history) {
    sum += widen(value) * power;
    power /= z;
  }
  return sum;
}

void expect_operators_hold(const TimeScheme& scheme, const Oscillator& o, double initial_load) {
  const double dt = 0.1;
  std::vector<double> load(600, 0.0);  // 1.1^-600 = 1e-25: what is cut off does not count
  load[0] = initial_load;
  for (std::size_t n = 1; n < 20; ++n) load[n] = std::sin(0.3 * static_cast<double>(n)) + initial_load;
  const Complex z = std::polar<Real>(1.1L, 0.7L);
  const SchemeOperators op = scheme_operators(scheme, dt, z);
  const Real mass = widen(o.mass), damping = widen(o.damping), stiffness = widen(o.stiffness);
  const Complex force = transform(load, z) + op.initial_load * widen(initial_load);
  const Complex reaction =
      (op.inertia * mass + op.damping * damping + stiffness) * transform(step_through(scheme, o, dt, load), z);
  EXPECT_LT(std::abs(reaction - force), 1e-13L * std::abs(force)) << scheme.beta << " " << scheme.alpha_f;
}

TEST(TimeScheme, OperatorsTransformTheRecursion) {
  for (const TimeScheme& scheme : all_schemes()) {
    expect_operators_hold(scheme, {2.0, 0.0, 3.0}, 0.0);
    expect_operators_hold(scheme, {2.0, 0.5, 3.0}, 0.0);
    expect_operators_hold(scheme, {2.0, 0.0, 3.0}, 1.5);
  }
}

// The closed form omega~^2 = -(z - 2 + 1/z)/(dt^2 (beta z + (1/2 + gamma - 2 beta) + (1/2 - gamma + beta)/z)).
TEST(TimeScheme, InertiaOperatorIsTheKnownClosedForm) {
  const double dt = 0.2;
  const Complex z = std::polar<Real>(1.05L, 0.4L);
  for (const TimeScheme& s : {thesis_scheme(), trapezoidal(), generalized_alpha(0.8)}) {
    const Real beta = widen(s.beta), gamma = widen(s.gamma), am = widen(s.alpha_m), af = widen(s.alpha_f);
    const Real one = 1, step = widen(dt);
    const Complex bracket = beta * z + (0.5L + gamma - 2 * beta) + (0.5L - gamma + beta) / z;
    const Complex filter = ((one - am) + am / z) / ((one - af) + af / z);
    const Complex expected = filter * (z - Real{2} + one / z) / (step * step * bracket);
    EXPECT_LT(std::abs(scheme_operators(s, dt, z).inertia - expected), 1e-16L * std::abs(expected));
  }
}

// A body under constant force with velocities carried over by k: v_end = g dt/(1 - k) in the limit.
TEST(TimeScheme, CarriedVelocityGivesTheTerminalVelocity) {
  TimeScheme scheme = thesis_scheme();
  scheme.carried_velocity = 0.9;
  const double dt = 0.1, g = 9.81;
  const std::vector<double> fall = step_through(scheme, {1, 0, 0}, dt, std::vector<double>(400, g));
  const double mean_velocity = (fall[399] - fall[398]) / dt;
  EXPECT_NEAR(mean_velocity, g * dt * (1 + 0.9) / (2 * (1 - 0.9)), 1e-12);  // 0.9^398 = 6e-19 remains
}

// Against the z-domain operator itself, whose square root is the frequency that the space operator must supply.
TEST(TimeScheme, PeriodErrorIsTheLeadingOrderOfTheOperator) {
  const double theta = 0.01;
  for (const TimeScheme& scheme : {thesis_scheme(), trapezoidal(), hht(0.1), generalized_alpha(0.8)}) {
    const Complex inertia = scheme_operators(scheme, 1.0, std::polar<Real>(1, widen(theta))).inertia;
    const double supplied = static_cast<double>(std::abs(std::sqrt(-inertia).real()));
    EXPECT_NEAR((supplied / theta - 1) * 2 / (theta * theta), period_error(scheme), theta * theta);
  }
}

}  // namespace
}  // namespace exact
