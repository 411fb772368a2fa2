#include "engine/record/csv.h"

#include <charconv>
#include <system_error>

namespace dda {

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

bool take_csv_cell(std::string_view& text, std::string& cell) {
  cell.clear();
  bool quoted = false;
  while (!text.empty()) {
    const char c = text.front();
    text.remove_prefix(1);
    if (c == '"' && quoted && text.starts_with('"')) {
      cell += '"';
      text.remove_prefix(1);
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && (c == ',' || c == '\n')) {
      return c == '\n';
    } else {
      cell += c;
    }
  }
  return true;
}

std::vector<std::string> take_csv_row(std::string_view& text) {
  std::vector<std::string> cells;
  for (bool last = false; !last;) last = take_csv_cell(text, cells.emplace_back());
  return cells;
}

std::optional<double> csv_number(std::string_view cell) {
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size()) return std::nullopt;
  return value;
}

}  // namespace dda
