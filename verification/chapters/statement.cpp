#include "verification/chapters/statement.h"

#include <fmt/format.h>

#include <algorithm>

namespace verify {
namespace {

long count(const std::vector<Reading>& readings, std::optional<bool> holds) {
  return std::count_if(readings.begin(), readings.end(), [&](const Reading& r) { return r.holds == holds; });
}

std::string listed(const std::vector<Reading>& readings, std::optional<bool> holds, const std::string& title) {
  std::string text;
  for (const Reading& reading : readings)
    if (reading.holds == holds)
      text += fmt::format("{}{} ({})", text.empty() ? "" : "; ", reading.name, reading.measured);
  return text.empty() ? "" : fmt::format(" {}: {}.", title, text);
}

std::optional<bool> majority(long yes, long no) {
  if (yes == no) return std::nullopt;
  return yes > no;
}

}  // namespace

Statement judged_over(Statement statement, const std::vector<Reading>& readings) {
  const long yes = count(readings, true);
  const long no = count(readings, false);
  statement.confirmed = majority(yes, no);
  if (readings.empty()) {
    statement.ours = std::string("not judged");
    statement.reason += " No run was made for it.";
    return statement;
  }
  statement.ours = fmt::format("confirmed for {} of {} readings", yes, yes + no);
  if (yes > 0 && yes <= no) statement.reason += listed(readings, true, "It holds in");
  if (no > 0) statement.reason += listed(readings, false, "It does not hold in");
  statement.reason += listed(readings, std::nullopt, "Not told by");
  return statement;
}

}  // namespace verify
