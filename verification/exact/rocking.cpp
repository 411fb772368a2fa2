#include "verification/exact/rocking.h"

#include <algorithm>
#include <cmath>

namespace exact {

double RockingBlock::slenderness_angle() const { return std::atan2(width, height); }
double RockingBlock::radius() const { return std::hypot(width, height) / 2; }

double rocking_frequency(const RockingBlock& block, double gravity) {
  return std::sqrt(3 * gravity / (4 * block.radius()));
}

double housner_period(const RockingBlock& block, double gravity, double theta0) {
  return 4 / rocking_frequency(block, gravity) * std::acosh(1 / (1 - theta0 / block.slenderness_angle()));
}

double rocking_period(const RockingBlock& block, double gravity, double theta0) {
  constexpr int intervals = 2000;
  const double alpha = block.slenderness_angle();
  const double s = std::sin((alpha - theta0) / 2);
  const double width = std::acosh(std::sin(alpha / 2) / s) / intervals;
  const auto integrand = [s](double u) { return 1 / std::sqrt(1 - std::pow(s * std::cosh(u), 2)); };
  double sum = 0;
  for (int i = 0; i < intervals; ++i)
    sum += integrand(i * width) + 4 * integrand((i + 0.5) * width) + integrand((i + 1) * width);
  return 4 / rocking_frequency(block, gravity) * sum * width / 6;
}

double rocking_impact_ratio(const RockingBlock& block) {
  return 1 - 1.5 * std::pow(std::sin(block.slenderness_angle()), 2);
}

double rocking_speed(const RockingBlock& block, double gravity, double theta0, double theta) {
  const double alpha = block.slenderness_angle();
  const double fall = std::cos(alpha - theta0) - std::cos(alpha - theta);
  return rocking_frequency(block, gravity) * std::sqrt(2 * fall);
}

double rocking_amplitude(const RockingBlock& block, double gravity, double speed) {
  const double alpha = block.slenderness_angle();
  const double p = rocking_frequency(block, gravity);
  return alpha - std::acos(std::cos(alpha) + speed * speed / (2 * p * p));
}

double uplift_acceleration(const RockingBlock& block, double gravity) { return gravity * block.width / block.height; }

double tilt_on_moving_floor(const RockingBlock& block, double gravity,
                            const std::function<double(double)>& acceleration, double time, int steps) {
  const double alpha = block.slenderness_angle();
  const double p_squared = std::pow(rocking_frequency(block, gravity), 2);
  // The foot takes no moment the other way: before uplift the block rests.
  const auto turning = [&](double t, double theta) {
    const double angle = alpha - std::max(theta, 0.0);
    const double a = p_squared * (acceleration(t) / gravity * std::cos(angle) - std::sin(angle));
    return theta > 0 ? a : std::max(a, 0.0);
  };
  const double dt = time / steps;
  double theta = 0;
  double speed = 0;
  for (int i = 0; i < steps; ++i) {
    const double t = i * dt;
    const double k1 = turning(t, theta);
    const double k2 = turning(t + dt / 2, theta + dt / 2 * speed);
    const double k3 = turning(t + dt / 2, theta + dt / 2 * speed + dt * dt / 4 * k1);
    const double k4 = turning(t + dt, theta + dt * speed + dt * dt / 2 * k2);
    theta += dt * speed + dt * dt / 6 * (k1 + k2 + k3);
    speed += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return theta;
}

}  // namespace exact
