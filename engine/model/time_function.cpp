#include "engine/model/time_function.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace dda {
namespace {

double value_at(const Constant&, double) { return 1.0; }

double value_at(const PiecewiseLinear& table, double time) {
  if (time <= table.times.front()) return table.values.front();
  if (time >= table.times.back()) return table.values.back();
  const auto next = std::upper_bound(table.times.begin(), table.times.end(), time);
  const auto i = static_cast<std::size_t>(next - table.times.begin());
  const double share = (time - table.times[i - 1]) / (table.times[i] - table.times[i - 1]);
  return table.values[i - 1] + share * (table.values[i] - table.values[i - 1]);
}

double value_at(const SineCycles& sine, double time) {
  const double phase = (time - sine.start) * sine.frequency;
  if (phase <= 0 || phase >= sine.cycles) return 0;
  return std::sin(2 * std::numbers::pi * phase);
}

double value_at(const ExponentialDecay& decay, double time) {
  const double since = time - decay.start;
  if (since < 0) return 0;
  return since < decay.rise ? since / decay.rise : std::exp(-(since - decay.rise) / decay.decay_time);
}

double value_at(const Recorded& recorded, double time) { return recorded.recording->value(time - recorded.start); }

}  // namespace

double evaluate(const TimeFunction& history, double time) {
  return std::visit([time](const auto& f) { return value_at(f, time); }, history);
}

}  // namespace dda
