#include "engine/model/same_history.h"

#include <tuple>
#include <variant>

namespace dda {

bool are_same(const TimeFunction& a, const TimeFunction& b) {
  if (a.index() != b.index()) return false;
  if (const auto* table = std::get_if<PiecewiseLinear>(&a)) {
    const auto& other = std::get<PiecewiseLinear>(b);
    return std::tie(table->times, table->values) == std::tie(other.times, other.values);
  }
  if (const auto* sine = std::get_if<SineCycles>(&a)) {
    const auto& other = std::get<SineCycles>(b);
    return std::tie(sine->frequency, sine->cycles, sine->start) == std::tie(other.frequency, other.cycles, other.start);
  }
  if (const auto* decay = std::get_if<ExponentialDecay>(&a)) {
    const auto& other = std::get<ExponentialDecay>(b);
    return std::tie(decay->decay_time, decay->start, decay->rise) ==
           std::tie(other.decay_time, other.start, other.rise);
  }
  if (const auto* recorded = std::get_if<Recorded>(&a)) {
    const auto& other = std::get<Recorded>(b);
    return std::tie(recorded->recording, recorded->start) == std::tie(other.recording, other.start);
  }
  return true;
}

}  // namespace dda
