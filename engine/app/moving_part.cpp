#include "engine/app/moving_part.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dda {

double first_moment(const nlohmann::ordered_json& summary) {
  constexpr double before_all = std::numeric_limits<double>::lowest();
  if (!summary.is_object()) return before_all;
  for (const auto& stage : summary.value("stages", nlohmann::ordered_json::array()))
    if (!stage.value("settles", false)) return stage.value("begin_s", 0.0);
  return before_all;
}

Histories from(double time, Histories histories) {
  constexpr double round_off = 1e-12;  // of times that are sums of steps
  const auto after = std::ranges::upper_bound(histories.times, time + round_off * std::abs(time));
  const auto first = std::max<std::ptrdiff_t>(after - histories.times.begin() - 1, 0);
  if (first + 1 >= std::ssize(histories.times)) return histories;
  histories.times.erase(histories.times.begin(), histories.times.begin() + first);
  for (HistoryColumn& column : histories.columns)
    column.values.erase(column.values.begin(), column.values.begin() + first);
  return histories;
}

std::vector<double> without_jumps(const std::vector<double>& times, std::vector<double> values) {
  double jumps = 0, last = values.empty() ? 0 : values.front();
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (times[i] == times[i - 1]) jumps += values[i] - last;
    last = values[i];
    values[i] -= jumps;
  }
  return values;
}

}  // namespace dda
