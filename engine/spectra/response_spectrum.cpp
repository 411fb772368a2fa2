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
    note_extrema(dt, line, start, end);
  }

  [[nodiscard]] double largest() const { return largest_; }

 private:
  struct Moment {
    double time = 0;  // s, since the start of the interval
    double rate = 0;  // of the displacement
  };

  void note(double displacement) { largest_ = std::max(largest_, std::abs(displacement)); }

  // Up to where the rate turns, and from there on, it has one zero at most.
  void note_extrema(double dt, const LeadingLine& line, const OscillatorState& start, double end) {
    const auto at_start = [&](int order) {
      return derivative(order_ + order, oscillator_, start, line.start, line.slope);
    };
    const auto at_end = [&](int order) { return derivative(order_ + order, oscillator_, state_, end, line.slope); };
    const Moment first{0, at_start(1)}, last{dt, at_end(1)};
    const double bend = at_start(2);
    const bool turns = (bend < 0) != (at_end(2) < 0);
    const double when = turns ? first_zero(oscillator_, bend, at_start(3)) : dt;
    if (!(when > 0 && when < dt)) return note_extremum(line, start, first, last);
    const Moment turn = moment_at(when, line, start);
    note_extremum(line, start, first, turn);
    note_extremum(line, start, turn, last);
  }

  Moment moment_at(double t, const LeadingLine& line, const OscillatorState& start) {
    const OscillatorState there = OscillatorStep(oscillator_, t).after(start, line);
    const double f = line.start + line.slope * t;
    note(derivative(order_, oscillator_, there, f, line.slope));
    return {t, derivative(order_ + 1, oscillator_, there, f, line.slope)};
  }

  // None where the rate has the same sign at both ends. Regula falsi on the rate, where an end that stays twice counts
  // half (the "Illinois" rule). What is off in the place of an extremum is off in its value by the square.
  void note_extremum(const LeadingLine& line, const OscillatorState& start, Moment left, Moment right) {
    constexpr double precision = 1e-8;  // of the interval
    if ((left.rate < 0) == (right.rate < 0)) return;
    const double interval = right.time - left.time;
    double last = left.time - interval;
    int stayed = 0;
    for (int i = 0; i < 60; ++i) {
      const double t = (left.time * right.rate - right.time * left.rate) / (right.rate - left.rate);
      if (!(t > left.time && t < right.time) || std::abs(t - last) < precision * interval) break;
      last = t;
      const Moment there = moment_at(t, line, start);
      if (there.rate == 0) break;
      const bool on_left = (there.rate < 0) == (left.rate < 0);
      (on_left ? left : right) = there;
      if (stayed == (on_left ? 1 : -1)) (on_left ? right : left).rate /= 2;
      stayed = on_left ? 1 : -1;
    }
  }

  Oscillator oscillator_;
  int order_;
  double dt_ = 0;
  std::optional<OscillatorStep> step_;
  OscillatorState state_;
  double largest_ = 0;  // m
};

// So short that no part has more than two extrema, and the rate no more than one between these. Oscillators of periods
// below an eighth of the interval go with the ground but for a share that is less than the period over the interval,
// and some parts will do.
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
