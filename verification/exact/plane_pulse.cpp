#include "verification/exact/plane_pulse.h"

#include <cmath>
#include <numbers>

namespace exact {
namespace {

constexpr int wave_numbers = 1200;
constexpr double largest_wave_number = 7.5;  // over s: exp(-7.5^2/2) = 6e-13

// x'' + a^2 x = sin(w t) from rest, sampled at equal intervals: driven for `end` (whole periods of w), then free.
class DrivenOscillator {
 public:
  // At resonance the difference quotient needs a and w apart: 1e-6 changes one wave number of the quadrature by 1e-6.
  DrivenOscillator(double a, double w, double end)
      : a_(std::abs(a / w - 1) < 1e-6 ? w * (1 + 1e-6) : a), w_(w), end_(end) {
    const double detuning = a_ * a_ - w * w;
    position_ = -w * std::sin(a_ * end) / (a_ * detuning);
    velocity_ = w * (1 - std::cos(a_ * end)) / detuning;
  }

  [[nodiscard]] double at(double t) const {
    if (t <= end_) return (a_ * std::sin(w_ * t) - w_ * std::sin(a_ * t)) / (a_ * (a_ * a_ - w_ * w_));
    return position_ * std::cos(a_ * (t - end_)) + velocity_ / a_ * std::sin(a_ * (t - end_));
  }

 private:
  double a_, w_, end_;
  double position_ = 0, velocity_ = 0;
};

// Radial derivative of the potential of speed c.
std::vector<double> potential_slope(const PlanePulse& pulse, double c, double r, double dt, int samples) {
  const double w = 2 * std::numbers::pi * pulse.frequency;
  const double interval = largest_wave_number / pulse.radius / wave_numbers;
  const double factor = -pulse.intensity / pulse.density * pulse.radius * pulse.radius * interval;
  std::vector<double> slope(static_cast<std::size_t>(samples), 0);
  for (int i = 1; i < wave_numbers; ++i) {
    const double k = i * interval;
    const double weight =
        factor * std::exp(-k * k * pulse.radius * pulse.radius / 2) * std::cyl_bessel_j(1, k * r) * k * k;
    const DrivenOscillator once(c * k, w, 1 / pulse.frequency);
    const DrivenOscillator twice(c * k, 2 * w, 1 / pulse.frequency);
    for (int n = 0; n < samples; ++n)
      slope[static_cast<std::size_t>(n)] += weight * (once.at(n * dt) - twice.at(n * dt) / 2);
  }
  return slope;
}

}  // namespace

double pulse_history(double frequency, double t) {
  const double angle = 2 * std::numbers::pi * frequency * t;
  return t <= 0 || t >= 1 / frequency ? 0 : std::sin(angle) * (1 - std::cos(angle));
}

SourceForce source_force(const PlanePulse& pulse, double x, double y) {
  const double square = pulse.radius * pulse.radius;
  const double factor = -pulse.intensity / square * std::exp(-(x * x + y * y) / (2 * square));
  return {factor * (x + y), factor * (y - x)};
}

DisplacementHistory displacement_history(const PlanePulse& pulse, double r, double dt, int samples) {
  return {potential_slope(pulse, pulse.p_speed, r, dt, samples), potential_slope(pulse, pulse.s_speed, r, dt, samples)};
}

}  // namespace exact
