#include "verification/suite/page_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>

namespace verify {
namespace {

enum Column : std::size_t { quantity, value, reference, error, tolerance, order };  // order only where a row has one

// ---- Writing.

// Below this an error may be round-off, which is not the same on every processor.
constexpr double smallest_digits = 1e-8;

// Notes below the table, each text once: a, b, ..., z, aa, ...
class Notes {
 public:
  std::string letters_of(const std::string& text) {
    const auto found = std::find(texts_.begin(), texts_.end(), text);
    const auto index = static_cast<std::size_t>(found - texts_.begin());
    if (found == texts_.end()) texts_.push_back(text);
    return letters(index);
  }
  [[nodiscard]] Lines lines() const {
    Lines lines;
    for (std::size_t i = 0; i < texts_.size(); ++i) lines.push_back(fmt::format("- ({}) {}", letters(i), texts_[i]));
    return lines;
  }

 private:
  static std::string letters(std::size_t index) {
    const std::string last(1, static_cast<char>('a' + index % 26));
    return index < 26 ? last : letters(index / 26 - 1) + last;
  }
  Lines texts_;
};

// Stars would set in italics.
std::string text_of(const std::string& plain) {
  std::string text;
  for (const char letter : plain) {
    if (letter == '*') text += '\\';
    text += letter;
  }
  return text;
}

// A bar would end the cell.
std::string cell_of(const std::string& plain) {
  std::string cell;
  for (const char letter : text_of(plain)) {
    if (letter == '|') cell += '\\';
    cell += letter;
  }
  return cell;
}

// "1e-09" as "1e-9", "5e+09" as "5e9".
std::string digits_of(double number, int digits) {
  std::string text = fmt::format("{:.{}g}", number, digits);
  const std::size_t mark = text.find('e');
  if (mark == std::string::npos) return text;
  const std::size_t sign = text[mark + 1] == '-' ? 1 : 0;
  const std::size_t first = text.find_first_not_of("+-0", mark + 1);
  return text.substr(0, mark + 1) + text.substr(mark + 1, sign) + text.substr(first);
}

// The power of ten that is three times the number or more, but no more than the tolerance.
std::string bound_of(double number, double tolerance) {
  const double power = std::pow(10, std::ceil(std::log10(std::max(3 * std::abs(number), 1e-12))));
  return "< " + digits_of(std::min(power, tolerance), 2);
}

// Counts, which are right or not.
bool is_exact(const Assertion& asserted) { return asserted.error == 0 && asserted.tolerance == 0; }

std::string error_cell(const Assertion& asserted) {
  if (is_exact(asserted)) return "0";
  if (std::abs(asserted.error) < smallest_digits) return bound_of(asserted.error, asserted.tolerance);
  return digits_of(asserted.error, 2);
}

std::string value_cell(const Assertion& asserted) {
  const bool nothing = asserted.reference == 0 && std::abs(asserted.value) < smallest_digits;
  return nothing && !is_exact(asserted) ? bound_of(asserted.value, asserted.tolerance) : digits_of(asserted.value, 6);
}

std::string order_cell(const Assertion& asserted) {
  return asserted.order ? fmt::format("{:.2f} ({:g})", asserted.order->observed, asserted.order->expected) : "";
}

std::string line_of(const Row& row, bool with_order, Notes& notes) {
  const Assertion& asserted = row.assertion;
  const std::string unit = asserted.unit.empty() ? "" : fmt::format(" [{}]", asserted.unit);
  const std::string source = notes.letters_of(text_of(asserted.source));
  const std::string reason = notes.letters_of(text_of(asserted.tolerance_reason));
  const std::string line = fmt::format("| {} | {} | {} ({}) | {} | {} ({}) |", cell_of(asserted.quantity + unit),
                                       value_cell(asserted), digits_of(asserted.reference, 6), source,
                                       error_cell(asserted), digits_of(asserted.tolerance, 2), reason);
  return with_order ? fmt::format("{} {} |", line, order_cell(asserted)) : line;
}

// ---- Comparing.

struct Figure {
  bool is_bound;  // "< 1e-12"
  double number;
  std::string rest;  // letters of a note, an expected order
};

std::optional<Figure> figure_of(const std::string& cell) {
  Figure figure{cell.starts_with("< "), 0, ""};
  const char* const start = cell.data() + (figure.is_bound ? 2 : 0);
  const auto [end, problem] = std::from_chars(start, cell.data() + cell.size(), figure.number);
  if (problem != std::errc()) return {};
  figure.rest = end;
  return figure;
}

// The cells of a table row, or nothing if the line is none.
std::vector<std::string> cells_of(const std::string& line) {
  if (!line.starts_with("| ") || !line.ends_with(" |")) return {};
  std::vector<std::string> cells(1);
  for (std::size_t i = 2; i + 1 < line.size(); ++i) {
    const bool ends_cell = line[i] == '|' && line[i - 1] != '\\';
    if (ends_cell) cells.emplace_back();
    if (!ends_cell) cells.back() += line[i];
  }
  for (std::string& cell : cells) {
    cell.erase(0, std::min(cell.find_first_not_of(' '), cell.size()));
    cell.erase(cell.find_last_not_of(' ') + 1);
  }
  return cells;
}

// How far two figures of a column may be apart: what is printed of them, or a fiftieth of the tolerance.
double allowed(Column column, const std::vector<std::string>& measured, double largest) {
  const auto number = [&](Column which) { return figure_of(measured[which]).value_or(Figure{}).number; };
  const double of_tolerance = 0.02 * number(tolerance);
  if (column == order) return 0.02;
  if (column == tolerance) return 0.05 * largest;
  if (column == error) return std::max(0.05 * largest, of_tolerance);
  const double scale = number(reference) == 0 ? 1 : std::abs(number(reference));
  return std::max(1e-5 * largest, of_tolerance * scale);
}

// Whether two rows say the same in one column.
bool agree(Column column, const std::vector<std::string>& printed, const std::vector<std::string>& measured) {
  if (printed[column] == measured[column]) return true;
  const std::optional<Figure> was = figure_of(printed[column]);
  const std::optional<Figure> is = figure_of(measured[column]);
  if (column == quantity || !was || !is || was->rest != is->rest) return false;
  const double largest = std::max(std::abs(was->number), std::abs(is->number));
  const double margin = allowed(column, measured, largest);
  // Round-off may be three times as large elsewhere, and then the next power of ten is printed.
  constexpr double next_power = 10.5;
  if (was->is_bound && is->is_bound) return is->number <= std::max(next_power * was->number, margin);
  if (was->is_bound) return std::abs(is->number) <= was->number + margin;
  if (is->is_bound) return std::abs(was->number) <= is->number + margin;
  return std::abs(was->number - is->number) <= margin;
}

void compare_cells(const std::vector<std::string>& printed, const std::vector<std::string>& measured,
                   std::vector<std::string>& found) {
  static constexpr const char* names[] = {"quantity", "value", "reference", "error", "tolerance", "order"};
  for (std::size_t i = value; i < printed.size(); ++i)
    if (!agree(static_cast<Column>(i), printed, measured))
      found.push_back(fmt::format("{}: {} is printed as \"{}\", measured is \"{}\"", measured[quantity], names[i],
                                  printed[i], measured[i]));
}

// Rows of a table of figures that are about the same quantity.
bool comparable(const std::vector<std::string>& printed, const std::vector<std::string>& measured) {
  return measured.size() > tolerance && measured.size() <= order + 1 && printed.size() == measured.size() &&
         printed[quantity] == measured[quantity];
}

}  // namespace

Lines page_table(const std::vector<Row>& rows) {
  const bool with_order =
      std::any_of(rows.begin(), rows.end(), [](const Row& row) { return row.assertion.order.has_value(); });
  Lines lines = {"| quantity | value | reference | error | tolerance |", "|---|---:|---:|---:|---:|"};
  if (with_order) lines = {lines[0] + " order (expected) |", lines[1] + "---:|"};
  Notes notes;
  for (const Row& row : rows) lines.push_back(line_of(row, with_order, notes));
  lines.emplace_back();
  for (std::string& line : notes.lines()) lines.push_back(std::move(line));
  return lines;
}

std::vector<Margin> margins_of(const Lines& printed) {
  std::vector<Margin> margins;
  for (const std::string& line : printed) {
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() <= tolerance) continue;
    const std::optional<Figure> took = figure_of(cells[error]);
    const std::optional<Figure> may_take = figure_of(cells[tolerance]);
    if (!took || !may_take) continue;  // the head of the table
    const bool is_nothing = took->is_bound || may_take->number == 0;
    margins.push_back({cells[quantity], is_nothing ? 0 : std::abs(took->number) / may_take->number});
  }
  return margins;
}

std::vector<std::string> differences(const Lines& printed, const Lines& measured) {
  if (printed.size() != measured.size()) return {"other quantities or notes are printed than there are"};
  std::vector<std::string> found;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const std::vector<std::string> was = cells_of(printed[i]);
    const std::vector<std::string> is = cells_of(measured[i]);
    if (comparable(was, is))
      compare_cells(was, is, found);
    else if (printed[i] != measured[i])
      found.push_back(fmt::format("\"{}\" is printed, it should be \"{}\"", printed[i], measured[i]));
  }
  return found;
}

}  // namespace verify
