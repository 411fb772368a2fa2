#include "engine/record/profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>
#include <vector>

#include "engine/record/atomic_file.h"

namespace dda {
namespace {

struct Row {
  const char* name;
  PhaseCost cost;
};

std::vector<Row> rows_of(const PhaseClock& clock) {
  const auto costs = clock.costs();
  std::vector<Row> rows;
  for (const PhaseName& each : phase_names)
    if (const PhaseCost& cost = costs[static_cast<std::size_t>(each.phase)]; cost.calls > 0)
      rows.push_back({each.name, cost});
  std::ranges::stable_sort(rows, std::greater(), [](const Row& row) { return row.cost.nanoseconds; });
  return rows;
}

double seconds(std::int64_t nanoseconds) { return 1e-9 * static_cast<double>(nanoseconds); }

double sum_of(const std::vector<Row>& rows) {
  std::int64_t sum = 0;
  for (const Row& row : rows) sum += row.cost.nanoseconds;
  return seconds(sum);
}

const char* name_of(Phase phase) { return phase_names[static_cast<std::size_t>(phase)].name; }

}  // namespace

std::string profile_table(const PhaseClock& clock, const Counters& counters) {
  const std::vector<Row> rows = rows_of(clock);
  const double whole = sum_of(rows);
  std::string table = fmt::format("{:32} {:>12} {:>12} {:>8}\n", "phase", "calls", "seconds", "share");
  const auto out = std::back_inserter(table);
  for (const auto& [name, cost] : rows)
    fmt::format_to(out, "{:32} {:12} {:12.6f} {:6.2f} %\n", name, cost.calls, seconds(cost.nanoseconds),
                   100 * seconds(cost.nanoseconds) / whole);
  fmt::format_to(out, "{:32} {:12} {:12.6f} {:6.2f} %\n", "all", "", whole, 100.0);
  for (const CounterField& field : counter_fields)
    if (counters.*field.value != 0) fmt::format_to(out, "{:32} {:12}\n", field.name, counters.*field.value);
  return table;
}

void write_profile(const std::filesystem::path& path, const PhaseClock& clock, const Counters& counters) {
  const std::vector<Row> rows = rows_of(clock);
  nlohmann::json summary = {{"wall_s", sum_of(rows)}, {"events_left_out", clock.events_left_out()}};
  for (const auto& [name, cost] : rows)
    summary["phases"].push_back({{"name", name}, {"calls", cost.calls}, {"seconds", seconds(cost.nanoseconds)}});
  for (const CounterField& field : counter_fields) summary["counters"][field.name] = counters.*field.value;
  std::string text =
      fmt::format("{{\"displayTimeUnit\": \"ms\",\n\"otherData\": {},\n\"traceEvents\": [", summary.dump());
  const char* between = "\n";
  for (const auto& [phase, begin, duration] : clock.events()) {
    fmt::format_to(std::back_inserter(text),
                   R"({}{{"name": "{}", "ph": "X", "pid": 1, "tid": 1, "ts": {}, "dur": {}}})", between, name_of(phase),
                   1e-3 * static_cast<double>(begin), 1e-3 * static_cast<double>(duration));
    between = ",\n";
  }
  text += "\n]}\n";
  write_file(path, text);
}

}  // namespace dda
