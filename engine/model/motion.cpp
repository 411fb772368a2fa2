#include "engine/model/motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace dda {
namespace {

// First and second derivative, or first and second integral, at a time.
struct Pair {
  double first = 0;
  double second = 0;
};

Pair derivatives(const Constant&, double) { return {}; }

Pair derivatives(const PiecewiseLinear& table, double time) {
  if (time < table.times.front() || time >= table.times.back()) return {};
  const auto next = std::upper_bound(table.times.begin(), table.times.end(), time);
  const auto i = static_cast<std::size_t>(next - table.times.begin());
  return {(table.values[i] - table.values[i - 1]) / (table.times[i] - table.times[i - 1]), 0};
}

Pair derivatives(const SineCycles& sine, double time) {
  const double turns = (time - sine.start) * sine.frequency;
  if (turns < 0 || turns >= sine.cycles) return {};
  const double omega = 2 * std::numbers::pi * sine.frequency;
  const double phase = 2 * std::numbers::pi * turns;
  return {omega * std::cos(phase), -omega * omega * std::sin(phase)};
}

Pair derivatives(const ExponentialDecay& decay, double time) {
  const double since = time - decay.start;
  if (since < 0) return {};
  if (since < decay.rise) return {1 / decay.rise, 0};
  const double value = std::exp(-(since - decay.rise) / decay.decay_time);
  return {-value / decay.decay_time, value / (decay.decay_time * decay.decay_time)};
}

Pair derivatives(const Recorded& recorded, double time) {
  return {recorded.recording->slope(time - recorded.start), 0};
}

// Integrals below are taken from a moment of each function's own; motion_at shifts them to t = 0.
Pair integrals(const Constant&, double time) { return {time, time * time / 2}; }

// Straight line from `value` with `slope`, integrated over t and added.
void advance(double value, double slope, double t, Pair& sum) {
  sum.second += t * (sum.first + t * (value / 2 + slope * t / 6));
  sum.first += t * (value + slope * t / 2);
}

Pair integrals(const PiecewiseLinear& table, double time) {
  Pair sum;
  if (time <= table.times.front()) {
    advance(table.values.front(), 0, time - table.times.front(), sum);
    return sum;
  }
  for (std::size_t i = 1; i < table.times.size(); ++i) {
    const double length = table.times[i] - table.times[i - 1];
    const double slope = (table.values[i] - table.values[i - 1]) / length;
    advance(table.values[i - 1], slope, std::min(time, table.times[i]) - table.times[i - 1], sum);
    if (time <= table.times[i]) return sum;
  }
  advance(table.values.back(), 0, time - table.times.back(), sum);
  return sum;
}

Pair integrals(const SineCycles& sine, double time) {
  const double since = time - sine.start;
  if (since <= 0) return {};
  const double omega = 2 * std::numbers::pi * sine.frequency;
  const double t = std::min(since, sine.cycles / sine.frequency);
  Pair sum{2 * std::pow(std::sin(omega * t / 2), 2) / omega, t / omega - std::sin(omega * t) / (omega * omega)};
  sum.second += sum.first * (since - t);
  return sum;
}

Pair integrals(const ExponentialDecay& decay, double time) {
  const double since = time - decay.start;
  if (since <= 0) return {};
  Pair sum;
  if (decay.rise > 0) advance(0, 1 / decay.rise, std::min(since, decay.rise), sum);
  const double falling = std::max(since - decay.rise, 0.0);
  const double first = -decay.decay_time * std::expm1(-falling / decay.decay_time);
  return {sum.first + first, sum.second + sum.first * falling + decay.decay_time * (falling - first)};
}

Pair integrals(const Recorded& recorded, double time) {
  const double t = time - recorded.start;
  return {recorded.recording->integral(t), recorded.recording->second_integral(t)};
}

Pair integrals_from_rest(const TimeFunction& history, double time) {
  const auto at = [&history](double t) { return std::visit([t](const auto& f) { return integrals(f, t); }, history); };
  const Pair start = at(0);
  const Pair end = at(time);
  return {end.first - start.first, end.second - start.second - start.first * time};
}

Pair derivatives_at(const TimeFunction& history, double time) {
  return std::visit([time](const auto& f) { return derivatives(f, time); }, history);
}

}  // namespace

MotionFactors motion_at(MotionKind kind, const TimeFunction& history, double time) {
  const double value = evaluate(history, time);
  if (kind == MotionKind::displacement) {
    const Pair rates = derivatives_at(history, time);
    return {value, rates.first, rates.second};
  }
  const Pair sums = integrals_from_rest(history, time);
  if (kind == MotionKind::velocity) return {sums.first, value, derivatives_at(history, time).first};
  return {sums.second, sums.first, value};
}

}  // namespace dda
