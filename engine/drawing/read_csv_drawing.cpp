#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "engine/core/error.h"
#include "engine/drawing/number_text.h"
#include "engine/drawing/read_formats.h"

namespace dda {
namespace {

enum Column { layer, x1, y1, x2, y2, x, y, column_count };

struct Heading {
  std::string_view text;  // in lower case, without blanks and punctuation
  Column column;
};

// The names of Appendix A of the thesis, and those that AutoCAD gives the columns of extracted data.
constexpr std::array<Heading, 13> headings{{{"layer", layer},
                                            {"x1", x1},
                                            {"y1", y1},
                                            {"x2", x2},
                                            {"y2", y2},
                                            {"x", x},
                                            {"y", y},
                                            {"startx", x1},
                                            {"starty", y1},
                                            {"endx", x2},
                                            {"endy", y2},
                                            {"positionx", x},
                                            {"positiony", y}}};

std::string bare(std::string_view text) {
  std::string letters;
  for (const char c : text) {
    if (c >= 'A' && c <= 'Z') letters += static_cast<char>(c - 'A' + 'a');
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) letters += c;
  }
  return letters;
}

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

class TableReader {
 public:
  TableReader(std::string_view text, const std::string& name, double metres) : rest_(text), metres_(metres) {
    drawing_.name = name;
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
  }

  LineDrawing read() {
    read_header();
    while (next_line()) read_row();
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

  void read_header() {
    constexpr const char* expected = "a header with layer and x1, y1, x2, y2 of lines, or x, y of points, or both";
    if (!next_line()) throw InputError("", drawing_.name, "empty", expected);
    for (const char candidate : {'\t', ';', ','}) {
      if (line_.find(candidate) != std::string_view::npos) separator_ = candidate;
    }
    if (line_.find(';') != std::string_view::npos) separator_ = ';';
    const std::vector<std::string_view> cells = cells_of(line_, separator_);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto known = std::ranges::find(headings, std::string_view(bare(cells[i])), &Heading::text);
      if (known != headings.end()) columns_[known->column] = i;
    }
    const auto has = [&](std::initializer_list<Column> wanted) {
      return std::ranges::all_of(wanted, [&](Column column) { return columns_[column].has_value(); });
    };
    has_lines_ = has({x1, y1, x2, y2});
    has_points_ = has({x, y});
    if (!has({layer}) || (!has_lines_ && !has_points_))
      throw InputError("", here(), "\"" + readable(line_.substr(0, 80)) + "\"", expected);
  }

  [[nodiscard]] std::string_view cell(Column column) const {
    const auto place = columns_[column];
    return place && *place < cells_.size() ? cells_[*place] : std::string_view();
  }

  [[nodiscard]] bool given(std::initializer_list<Column> columns) const {
    return std::ranges::any_of(columns, [&](Column column) { return !cell(column).empty(); });
  }

  void read_row() {
    cells_ = cells_of(line_, separator_);
    const std::string name = readable(cell(layer));
    if (name.empty()) throw InputError("", here(), "without a layer", "a name in the column layer");
    const bool line = has_lines_ && given({x1, y1, x2, y2});
    const bool point = has_points_ && given({x, y});
    if (!line && !point) throw InputError("", here(), "without coordinates", "those of a line or a point");
    if (line) pencil_.add(DrawnLine{name, here(), place(x1, y1), {{place(x2, y2), nullptr}}});
    if (point) pencil_.add(DrawnPoint{name, here(), place(x, y)});
  }

  [[nodiscard]] Vec2 place(Column first, Column second) const {
    return metres_ * Vec2(coordinate(first), coordinate(second));
  }

  // Where the comma does not part cells it may part the decimals.
  [[nodiscard]] double coordinate(Column column) const {
    std::string text(cell(column));
    if (separator_ != ',') std::ranges::replace(text, ',', '.');
    const auto number = number_in<double>(text);
    constexpr std::array<std::string_view, column_count> names{"layer", "x1", "y1", "x2", "y2", "x", "y"};
    if (!number)
      throw InputError("", fmt::format("{}, column {}", here(), names[column]),
                       "\"" + readable(text.substr(0, 40)) + "\"", "a finite number");
    return *number;
  }

  std::string_view rest_;
  double metres_;
  LineDrawing drawing_;
  Pencil pencil_{drawing_};
  std::string_view line_;
  std::size_t line_number_ = 0;
  char separator_ = ',';
  std::array<std::optional<std::size_t>, column_count> columns_;
  bool has_lines_ = false, has_points_ = false;
  std::vector<std::string_view> cells_;
};

}  // namespace

LineDrawing read_csv_drawing(std::string_view text, const std::string& name, double metres) {
  return TableReader(text, name, metres > 0 ? metres : 1).read();
}

}  // namespace dda
