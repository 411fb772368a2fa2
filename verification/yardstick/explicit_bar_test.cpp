#include "verification/yardstick/explicit_bar.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace yardstick {
namespace {

constexpr double pi = std::numbers::pi;

// A free bar: cos(k x) with a whole number of half waves is a mode of the discrete bar as of the continuous one.
double mode_frequency(const Bar& bar, double dt, int half_waves) {
  const double h = bar.element_length();
  const double k = half_waves * pi / bar.length;
  const double c = std::sqrt(bar.young / bar.density);
  return 2 / dt * std::asin(c * dt / h * std::sin(k * h / 2));
}

void start_mode(ExplicitBar& run, const Bar& bar, double dt, int half_waves, double omega) {
  const double k = half_waves * pi / bar.length;
  for (std::size_t i = 0; i < run.displacement().size(); ++i) {
    const double shape = std::cos(k * static_cast<double>(i) * bar.element_length());
    run.displacement()[i] = shape;
    run.velocity()[i] = shape * (1 - std::cos(omega * dt)) / dt;  // it stood at cos(omega dt) a step ago
  }
}

// sin(omega dt/2) = (c dt/h) sin(k h/2), Hughes 1987, section 9.1.
TEST(ExplicitBar, KeepsTheClosedFormOfDispersion) {
  const Bar bar{2650, 50e9, 2, 100, 50};
  const double c = std::sqrt(bar.young / bar.density);
  for (const double cfl : {0.3, 0.9, 1.0}) {
    const double dt = cfl * bar.element_length() / c;
    for (const int half_waves : {1, 10, 35}) {
      const double omega = mode_frequency(bar, dt, half_waves);
      ExplicitBar run(bar, dt);
      start_mode(run, bar, dt, half_waves, omega);
      for (int n = 1; n <= 200; ++n) {
        run.step(0);
        ASSERT_NEAR(run.displacement()[0], std::cos(omega * n * dt), 1e-11) << cfl << " " << half_waves << " " << n;
      }
    }
  }
}

double pulse(double t) { return t <= 0 || t >= 1 ? 0 : std::pow(std::sin(pi * t), 4); }

// Relative L2 error of the stress that a smooth push on the end of a bar with c = E = A = 1 sends past x = 1.
double pulse_error(int elements_per_length, double cfl) {
  const Bar bar{1, 1, 1, 3, 3 * elements_per_length};
  const double dt = cfl * bar.element_length();
  ExplicitBar run(bar, dt);
  double difference = 0, size = 0;
  for (int n = 0; n * dt < 3; ++n) {
    const double exact = -pulse(n * dt - 1);
    difference += std::pow(run.stress_at_node(elements_per_length) - exact, 2);
    size += exact * exact;
    run.step(pulse(n * dt));
  }
  return std::sqrt(difference / size);
}

TEST(ExplicitBar, ConvergesWithOrderTwo) {
  const double order = std::log2(pulse_error(80, 0.7) / pulse_error(160, 0.7));
  EXPECT_NEAR(order, 2, 0.05);
}

// c dt = h: waves go on by an element a step, unchanged. What is left is the end, loaded over half an element, and the
// mean of two elements: |shape''| h^2/2 at most.
TEST(ExplicitBar, CarriesWavesUnchangedAtTheLimitOfStability) {
  const Bar bar{1, 1, 1, 3, 120};
  const double dt = bar.element_length();
  ExplicitBar run(bar, dt);
  std::vector<double> near, far;
  for (int n = 0; n < 110; ++n) {
    near.push_back(run.stress_at_node(20));
    far.push_back(run.stress_at_node(60));
    run.step(pulse(n * dt));
  }
  for (std::size_t n = 40; n < far.size(); ++n) EXPECT_NEAR(far[n], near[n - 40], 1e-12);
}

// Momentum is the impulse of the force, whatever the bar does.
TEST(ExplicitBar, TakesUpTheImpulse) {
  const Bar bar{2650, 50e9, 2, 10, 7};
  ExplicitBar run(bar, 1e-4);
  for (int n = 0; n < 50; ++n) run.step(3e5);
  double momentum = 0;
  for (std::size_t i = 0; i < 8; ++i) momentum += run.velocity()[i] * (i == 0 || i == 7 ? 0.5 : 1);
  momentum *= bar.density * bar.area * bar.element_length();
  EXPECT_NEAR(momentum / (3e5 * 50 * 1e-4), 1, 1e-12);
}

}  // namespace
}  // namespace yardstick
