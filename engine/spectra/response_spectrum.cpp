#include "engine/spectra/response_spectrum.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/spectra/oscillator.h"

namespace dda {
namespace {

// The record leads w, and the displacement against the ground is this derivative of w.
int order_of(GroundMotion kind) {
  switch (kind) {
    case GroundMotion::acceleration: return 0;
    case GroundMotion::velocity: return 1;
    case GroundMotion::displacement: return 2;
  }
  return 0;
}

class Follower {
 public:
  Follower(const Oscillator& oscillator, GroundMotion kind) : oscillator_(oscillator), order_(order_of(kind)) {}

  void follow(double dt, const LeadingLine& line) {
    if (!step_ || std::abs(dt - dt_) > 1e-9 * dt_) {  // times are sums, and their differences off by round-off
      step_.emplace(oscillator_, dt);
      dt_ = dt;
    }
    const OscillatorState start = state_;
    note(derivative(order_, oscillator_, start, line.start, line.slope));  // where a displacement jumps, so does this
    state_ = step_->after(start, line);
    const double end = line.start + line.slope * dt;
    note(derivative(order_, oscillator_, state_, end, line.slope));
    const double rate_at_start = derivative(order_ + 1, oscillator_, start, line.start, line.slope);
    const double rate_at_end = derivative(order_ + 1, oscillator_, state_, end, line.slope);
    if ((rate_at_start < 0) != (rate_at_end < 0)) note_extremum(dt, line, start, rate_at_start, rate_at_end);
  }

  [[nodiscard]] double largest() const { return largest_; }

 private:
  void note(double displacement) { largest_ = std::max(largest_, std::abs(displacement)); }

  // Regula falsi on the rate, where an end that stays twice counts half (the "Illinois" rule). What is off in the
  // place of an extremum is off in its value by the square.
  void note_extremum(double dt, const LeadingLine& line, const OscillatorState& start, double rate_left,
                     double rate_right) {
    constexpr double precision = 1e-8;  // of the interval
    double left = 0, right = dt, last = -dt;
    int stayed = 0;
    for (int i = 0; i < 60; ++i) {
      const double t = (left * rate_right - right * rate_left) / (rate_right - rate_left);
      if (!(t > left && t < right) || std::abs(t - last) < precision * dt) break;
      last = t;
      const OscillatorState there = OscillatorStep(oscillator_, t).after(start, line);
      const double f = line.start + line.slope * t;
      note(derivative(order_, oscillator_, there, f, line.slope));
      const double rate = derivative(order_ + 1, oscillator_, there, f, line.slope);
      if (rate == 0) break;
      if ((rate < 0) == (rate_left < 0)) {
        left = t;
        rate_left = rate;
        if (stayed == 1) rate_right /= 2;
        stayed = 1;
      } else {
        right = t;
        rate_right = rate;
        if (stayed == -1) rate_left /= 2;
        stayed = -1;
      }
    }
  }

  Oscillator oscillator_;
  int order_;
  double dt_ = 0;
  std::optional<OscillatorStep> step_;
  OscillatorState state_;
  double largest_ = 0;  // m
};

// So short that no part has more than one extremum. Oscillators of periods below an eighth of the interval go with the
// ground but for a share that is less than the period over the interval, and some parts will do.
int parts_of(double interval, double period) {
  constexpr double parts_of_period = 8;
  constexpr double most = 64;
  return static_cast<int>(std::ceil(std::min(parts_of_period * interval / period, most)));
}

}  // namespace

double spectral_displacement(const MotionRecord& record, double period, double damping_ratio) {
  Follower follower({2 * std::numbers::pi / period, damping_ratio}, record.kind);
  const double at_rest = record.kind == GroundMotion::acceleration || record.values.empty() ? 0 : record.values.front();
  for (std::size_t i = 1; i < record.times.size(); ++i) {
    const double dt = record.times[i] - record.times[i - 1];
    if (!(dt > 0)) continue;
    const LeadingLine line{record.values[i - 1] - at_rest, (record.values[i] - record.values[i - 1]) / dt};
    const int parts = parts_of(dt, period);
    for (int part = 0; part < parts; ++part)
      follower.follow(dt / parts, {line.start + line.slope * dt * part / parts, line.slope});
  }
  return follower.largest();
}

PeriodRange resolved_periods(const std::vector<double>& times) {
  constexpr double samples = 10;  // a straight line between samples of a sine keeps sinc^2(pi/samples) of it: 97 %
  double longest = 0;
  for (std::size_t i = 1; i < times.size(); ++i) longest = std::max(longest, times[i] - times[i - 1]);
  return {samples * longest, times.empty() ? 0 : times.back() - times.front()};
}

std::vector<double> spaced_evenly_in_logarithm(const PeriodRange& range, std::size_t count) {
  std::vector<double> periods;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0;
    periods.push_back(i + 1 == count && count > 1 ? range.longest
                                                  : range.shortest * std::pow(range.longest / range.shortest, share));
  }
  return periods;
}

}  // namespace dda
