#include "verification/study/values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace verify {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

void add_counters(const dda::Counters& counters, Json& json) {
  for (const dda::CounterField& field : dda::counter_fields) json[field.name] = counters.*field.value;
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of("\",\n\r") == std::string::npos) return text;
  std::string result(1, '"');
  for (const char c : text) {
    result += c == '\n' ? ' ' : c;
    if (c == '"') result += c;
  }
  result += '"';
  return result;
}

std::string csv_cell(const Json& value) {
  if (value.is_null()) return "";
  return csv_cell(value.is_string() ? value.get<std::string>() : value.dump());
}

std::string csv_line(const std::vector<std::string>& cells) { return fmt::format("{}\n", fmt::join(cells, ",")); }

}  // namespace verify
