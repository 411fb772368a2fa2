#include <fmt/format.h>

#include <utility>

#include "engine/core/error.h"
#include "engine/drawing/layer_table.h"
#include "engine/drawing/number_text.h"
#include "engine/drawing/read_formats.h"

namespace dda {
namespace {

std::string_view unquoted(std::string_view cell) {
  cell = without_blanks(cell);
  const bool quoted = cell.size() >= 2 && cell.front() == '"' && cell.back() == '"';
  return quoted ? without_blanks(cell.substr(1, cell.size() - 2)) : cell;
}

std::vector<std::string_view> cells_of(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  bool quoted = false;
  std::size_t from = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (line[i] != separator || quoted) continue;
    cells.push_back(unquoted(line.substr(from, i - from)));
    from = i + 1;
  }
  cells.push_back(unquoted(line.substr(from)));
  return cells;
}

char separator_of(std::string_view header) {
  for (const char candidate : {';', ',', '\t'}) {
    if (header.find(candidate) != std::string_view::npos) return candidate;
  }
  return ',';
}

class CsvReader {
 public:
  CsvReader(std::string_view text, const std::string& name) : rest_(text) {
    drawing_.name = name;
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
  }

  LineDrawing read(double metres) {
    if (!next_line()) throw InputError("", drawing_.name, "empty", table_header);
    const char separator = separator_of(line_);
    LayerTable table(drawing_, metres, separator != ',');
    table.read_header(cells_of(line_, separator), here(), line_);
    while (next_line()) table.read_row(cells_of(line_, separator), here());
    return std::move(drawing_);
  }

 private:
  [[nodiscard]] std::string here() const { return fmt::format("{} line {}", drawing_.name, line_number_); }

  // The next line that says something.
  bool next_line() {
    while (!rest_.empty()) {
      const std::size_t end = rest_.find('\n');
      line_ = rest_.substr(0, end);
      rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
      if (line_.ends_with('\r')) line_.remove_suffix(1);
      ++line_number_;
      const bool says_nothing = line_.find_first_not_of(" \t,;") == std::string_view::npos;
      if (!says_nothing && line_.front() != '#') return true;
    }
    return false;
  }

  std::string_view rest_;
  LineDrawing drawing_;
  std::string_view line_;
  std::size_t line_number_ = 0;
};

}  // namespace

LineDrawing read_csv_drawing(std::string_view text, const std::string& name, double metres) {
  return CsvReader(text, name).read(metres > 0 ? metres : 1);
}

}  // namespace dda
