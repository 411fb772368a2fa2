#include "engine/advice/history_span.h"

#include <variant>

namespace dda {

HistorySpan changing(const TimeFunction& history) {
  if (const auto* table = std::get_if<PiecewiseLinear>(&history)) return {table->times.front(), table->times.back()};
  if (const auto* sine = std::get_if<SineCycles>(&history))
    return {sine->start, sine->start + sine->cycles / sine->frequency};
  if (const auto* decay = std::get_if<ExponentialDecay>(&history)) {
    constexpr double gone = 10;  // decay times: 5e-5 is left
    return {decay->start, decay->start + decay->rise + gone * decay->decay_time};
  }
  if (const auto* record = std::get_if<Recorded>(&history))
    return {record->start + record->recording->times().front(), record->start + record->recording->times().back()};
  return {};
}

}  // namespace dda
