#include "engine/spectra/oscillator.h"

#include <cmath>
#include <numbers>

namespace dda {
namespace {

// h and its integrals at the end of an interval.
struct Impulse {
  double h = 0, rate = 0, integral = 0, twice = 0;
};

// By closed forms: the equation of h, integrated once and twice, gives its integrals.
Impulse in_closed_form(const Oscillator& oscillator, double t) {
  const double omega = oscillator.omega, damping = 2 * oscillator.ratio * omega;
  const double damped = omega * std::sqrt((1 - oscillator.ratio) * (1 + oscillator.ratio));
  const double decay = std::exp(-oscillator.ratio * omega * t);
  Impulse impulse;
  impulse.h = decay * std::sin(damped * t) / damped;
  impulse.rate = decay * std::cos(damped * t) - damping / 2 * impulse.h;
  impulse.integral = (1 - impulse.rate - damping * impulse.h) / (omega * omega);
  impulse.twice = (t - impulse.h - damping * impulse.integral) / (omega * omega);
  return impulse;
}

// By the power series of h, whose terms follow from its equation; where omega t is small, the closed forms are
// differences of nearly equal numbers.
Impulse by_series(const Oscillator& oscillator, double t) {
  const double x = oscillator.omega * t;
  Impulse impulse{0, 1, 0, 0};
  double before = 0, term = t;  // of powers n - 1 and n of t in h
  for (int n = 1; n < 40; ++n) {
    impulse.h += term;
    impulse.integral += term * t / (n + 1);
    impulse.twice += term * t * t / ((n + 1) * (n + 2));
    const double next = -(2 * oscillator.ratio * x * n * term + x * x * before) / (n * (n + 1));
    impulse.rate += next * (n + 1) / t;
    before = term;
    term = next;
  }
  return impulse;
}

}  // namespace

double derivative(int order, const Oscillator& oscillator, const OscillatorState& state, double f, double slope) {
  if (order == 0) return state.value;
  if (order == 1) return state.rate;
  const double stiffness = oscillator.omega * oscillator.omega;
  const double damping = 2 * oscillator.ratio * oscillator.omega;
  double before = state.rate;
  double last = -f - damping * state.rate - stiffness * state.value;
  for (int i = 2; i < order; ++i) {
    const double next = (i == 2 ? -slope : 0) - damping * last - stiffness * before;
    before = last;
    last = next;
  }
  return last;
}

double first_zero(const Oscillator& oscillator, double value, double rate) {
  const double damped = oscillator.omega * std::sqrt((1 - oscillator.ratio) * (1 + oscillator.ratio));
  const double angle = std::atan2(-value, (rate + oscillator.ratio * oscillator.omega * value) / damped);
  return (angle > 0 ? angle : angle + std::numbers::pi) / damped;
}

OscillatorStep::OscillatorStep(const Oscillator& oscillator, double dt)
    : stiffness_(oscillator.omega * oscillator.omega), damping_(2 * oscillator.ratio * oscillator.omega) {
  const Impulse impulse = oscillator.omega * dt < 1 ? by_series(oscillator, dt) : in_closed_form(oscillator, dt);
  h_ = impulse.h;
  rate_of_h_ = impulse.rate;
  integral_ = impulse.integral;
  twice_ = impulse.twice;
}

OscillatorState OscillatorStep::after(const OscillatorState& state, const LeadingLine& line) const {
  return {(rate_of_h_ + damping_ * h_) * state.value + h_ * state.rate - integral_ * line.start - twice_ * line.slope,
          -stiffness_ * h_ * state.value + rate_of_h_ * state.rate - h_ * line.start - integral_ * line.slope};
}

}  // namespace dda
