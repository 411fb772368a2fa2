#include "engine/drawing/layer_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/core/error.h"
#include "engine/drawing/number_text.h"

namespace dda {

struct LayerTable::Heading {
  std::string_view text;  // in lower case, without blanks and punctuation
  Column column;
};

// The names of Appendix A of the thesis, and those that AutoCAD gives the columns of extracted data.
constexpr std::array<LayerTable::Heading, 13> LayerTable::headings{{{"layer", layer},
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

namespace {

std::string bare(std::string_view text) {
  std::string letters;
  for (const char c : text) {
    if (c >= 'A' && c <= 'Z') letters += static_cast<char>(c - 'A' + 'a');
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) letters += c;
  }
  return letters;
}

}  // namespace

bool LayerTable::is_header(const std::vector<std::string_view>& cells) {
  return std::ranges::any_of(cells, [](std::string_view cell) { return bare(cell) == "layer"; });
}

void LayerTable::read_header(const std::vector<std::string_view>& cells, const std::string& here,
                             std::string_view text) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto known = std::ranges::find(headings, std::string_view(bare(cells[i])), &Heading::text);
    if (known == headings.end()) continue;
    if (columns_[known->column])
      throw InputError("", here, fmt::format("with a second column {}", known->text), "each column once");
    columns_[known->column] = i;
  }
  width_ = cells.size();
  const auto has = [&](std::initializer_list<Column> wanted) {
    return std::ranges::all_of(wanted, [&](Column column) { return columns_[column].has_value(); });
  };
  has_lines_ = has({x1, y1, x2, y2});
  has_points_ = has({x, y});
  if (!has({layer}) || (!has_lines_ && !has_points_))
    throw InputError("", here, "\"" + readable(text.substr(0, 80)) + "\"", table_header);
}

void LayerTable::read_row(const std::vector<std::string_view>& cells, const std::string& here) {
  cells_ = &cells;
  here_ = &here;
  const auto is_said = [](std::string_view text) { return !text.empty(); };
  if (cells.size() > width_ && std::any_of(cells.begin() + static_cast<std::ptrdiff_t>(width_), cells.end(), is_said))
    throw InputError(
        "", here, fmt::format("with {} cells", cells.size()),
        fmt::format("at most {}, as in the header; where numbers have decimal commas columns are parted by "
                    "semicolons",
                    width_));
  const std::string name = readable(cell(layer));
  if (name.empty()) throw InputError("", here, "without a layer", "a name in the column layer");
  const bool line = has_lines_ && given({x1, y1, x2, y2});
  const bool point = has_points_ && given({x, y});
  if (!line && !point) throw InputError("", here, "without coordinates", "those of a line or a point");
  if (line) pencil_.add(DrawnLine{name, here, place(x1, y1), {{place(x2, y2), nullptr}}, ""});
  if (point) pencil_.add(DrawnPoint{name, here, place(x, y)});
}

std::string_view LayerTable::cell(Column column) const {
  const auto place = columns_[column];
  return place && *place < cells_->size() ? (*cells_)[*place] : std::string_view();
}

bool LayerTable::given(std::initializer_list<Column> columns) const {
  return std::ranges::any_of(columns, [&](Column column) { return !cell(column).empty(); });
}

Vec2 LayerTable::place(Column first, Column second) const {
  return metres_ * Vec2(coordinate(first), coordinate(second));
}

double LayerTable::coordinate(Column column) const {
  std::string text(cell(column));
  if (decimal_commas_) std::ranges::replace(text, ',', '.');
  const auto number = number_in<double>(text);
  constexpr std::array<std::string_view, column_count> names{"layer", "x1", "y1", "x2", "y2", "x", "y"};
  if (!number)
    throw InputError("", fmt::format("{}, column {}", *here_, names[column]),
                     "\"" + readable(text.substr(0, 40)) + "\"", "a finite number");
  return *number;
}

}  // namespace dda
