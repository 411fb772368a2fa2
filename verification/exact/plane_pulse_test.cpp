#include "verification/exact/plane_pulse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace exact {
namespace {

const PlanePulse pulse{2650, 4486, 2747, 5, 100, 1e6};
constexpr double place = 30;  // m

double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::abs(value));
  return result;
}

// u'' = c^2 (u'' + u'/r - u/r^2) + source/rho over r, by central differences in r and t: shares nothing with Hankel.
std::vector<double> by_differences(double c, double spacing, double dt, int samples) {
  const int points = static_cast<int>((place + c * dt * samples) / spacing) + 2;
  std::vector<double> before(static_cast<std::size_t>(points), 0), now = before, after = before, result;
  for (int n = 0; n < samples; ++n) {
    result.push_back(now[static_cast<std::size_t>(std::lround(place / spacing))]);
    for (int i = 1; i + 1 < points; ++i) {
      const auto j = static_cast<std::size_t>(i);
      const double r = i * spacing;
      const double laplacian = (now[j + 1] - 2 * now[j] + now[j - 1]) / (spacing * spacing) +
                               (now[j + 1] - now[j - 1]) / (2 * spacing * r) - now[j] / (r * r);
      const double source = -pulse.intensity * r / (pulse.radius * pulse.radius) *
                            std::exp(-r * r / (2 * pulse.radius * pulse.radius)) *
                            pulse_history(pulse.frequency, n * dt);
      after[j] = 2 * now[j] - before[j] + dt * dt * (c * c * laplacian + source / pulse.density);
    }
    before.swap(now);
    now.swap(after);
  }
  return result;
}

double difference(double c, const std::vector<double>& exact, int refinement, double dt) {
  const std::vector<double> found =
      by_differences(c, 0.5 / refinement, dt / refinement, (static_cast<int>(exact.size()) - 1) * refinement + 1);
  double result = 0;
  for (std::size_t i = 0; i < exact.size(); ++i)
    result = std::max(result, std::abs(found[i * static_cast<std::size_t>(refinement)] - exact[i]));
  return result / largest(exact);
}

// The differences come closer with order 2, and the extrapolated rest is none.
TEST(PlanePulse, AgreesWithFiniteDifferences) {
  const double dt = 5e-5;
  const DisplacementHistory history = displacement_history(pulse, place, dt, 520);
  for (const bool p : {true, false}) {
    const std::vector<double>& exact = p ? history.outward : history.clockwise;
    const double c = p ? pulse.p_speed : pulse.s_speed;
    const double coarse = difference(c, exact, 2, dt), fine = difference(c, exact, 4, dt);
    EXPECT_LT(fine, 2e-3) << p;
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.05) << p;
  }
}

// Causal up to the rim of the source: 6 radii off, exp(-18).
TEST(PlanePulse, DoesNotArriveTooEarly) {
  const double dt = 1e-4;
  const DisplacementHistory history = displacement_history(pulse, 60, dt, 300);
  for (std::size_t i = 0; i < 300; ++i) {
    if (pulse.p_speed * static_cast<double>(i) * dt < 30) {
      EXPECT_LT(std::abs(history.outward[i]), 1e-7 * largest(history.outward));
    }
    if (pulse.s_speed * static_cast<double>(i) * dt < 30) {
      EXPECT_LT(std::abs(history.clockwise[i]), 1e-7 * largest(history.clockwise));
    }
  }
}

TEST(PlanePulse, ForceIsTheGradientAndTheRotation) {
  const double step = 1e-4, x = 3, y = -2;
  const auto bell = [](double a, double b) {
    return pulse.intensity * std::exp(-(a * a + b * b) / (2 * pulse.radius * pulse.radius));
  };
  const double along_x = (bell(x + step, y) - bell(x - step, y)) / (2 * step);
  const double along_y = (bell(x, y + step) - bell(x, y - step)) / (2 * step);
  const SourceForce force = source_force(pulse, x, y);
  EXPECT_NEAR(force.x, along_x + along_y, 1e-3);
  EXPECT_NEAR(force.y, along_y - along_x, 1e-3);
}

}  // namespace
}  // namespace exact
