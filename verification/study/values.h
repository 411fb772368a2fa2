// Values as files have them: JSON and CSV.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/counters.h"

namespace verify {

// What is not there is null.
[[nodiscard]] nlohmann::ordered_json or_null(const std::optional<double>& value);

// Adds each counter under its name.
void add_counters(const dda::Counters& counters, nlohmann::ordered_json& json);

// A text as a cell of CSV: in quotes where it must be, line breaks as blanks.
[[nodiscard]] std::string csv_cell(const std::string& text);

// A value as a cell of CSV; null is empty.
[[nodiscard]] std::string csv_cell(const nlohmann::ordered_json& value);

// The cells between commas, with the line's end.
[[nodiscard]] std::string csv_line(const std::vector<std::string>& cells);

}  // namespace verify
