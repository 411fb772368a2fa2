#include "engine/app/moving_part.h"

#include <algorithm>

namespace dda {

double first_moment(const nlohmann::ordered_json& summary) {
  if (!summary.is_object()) return 0;
  for (const auto& stage : summary.value("stages", nlohmann::ordered_json::array()))
    if (!stage.value("settles", false)) return stage.value("begin_s", 0.0);
  return 0;
}

Histories from(double time, Histories histories) {
  const auto first = std::ranges::lower_bound(histories.times, time) - histories.times.begin();
  if (first + 1 >= static_cast<std::ptrdiff_t>(histories.times.size())) return histories;
  histories.times.erase(histories.times.begin(), histories.times.begin() + first);
  for (HistoryColumn& column : histories.columns)
    column.values.erase(column.values.begin(), column.values.begin() + first);
  return histories;
}

}  // namespace dda
