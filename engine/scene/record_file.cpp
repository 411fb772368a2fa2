#include "engine/scene/record_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <string_view>
#include <system_error>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/core/text_encoding.h"
#include "engine/scene/json_path.h"

namespace dda {
namespace {

constexpr std::size_t longest_line = 1 << 14;  // bytes

std::string_view trimmed(std::string_view text, const char* blanks = " \t\r") {
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string_view unquoted(std::string_view text) {
  const bool quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
  return quoted ? trimmed(text.substr(1, text.size() - 2)) : text;
}

std::vector<std::string_view> cells_of(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  while (true) {
    const auto end = line.find(separator);
    cells.push_back(unquoted(trimmed(line.substr(0, end))));
    if (end == std::string_view::npos) return cells;
    line.remove_prefix(end + 1);
  }
}

// A number and nothing else; NaN where there is none.
double number_in(std::string_view cell) {
  if (cell.size() > 1 && cell[0] == '+' && cell[1] != '-') cell.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  const bool whole = error == std::errc() && end == cell.data() + cell.size();
  return whole ? number : std::nan("");
}

struct Column {
  std::string name;
  std::string unit;  // without its brackets; empty where there is none
};

Column column_of(std::string_view cell) {
  for (const auto& [open, close] : {std::pair('[', ']'), std::pair('(', ')')}) {
    const auto at = cell.rfind(open);
    if (at == std::string_view::npos || cell.back() != close) continue;
    return {std::string(trimmed(cell.substr(0, at))), std::string(trimmed(cell.substr(at + 1, cell.size() - at - 2)))};
  }
  return {std::string(cell), ""};
}

// What of a recording comes after a moment within it.
Recording part_after(double from, const Recording& recording) {
  std::vector<double> times{from}, values{recording.value(from)};
  for (std::size_t i = 0; i < recording.times().size(); ++i) {
    if (recording.times()[i] <= from) continue;
    times.push_back(recording.times()[i]);
    values.push_back(recording.values()[i]);
  }
  return {recording.name(), std::move(times), std::move(values)};
}

// A motion begins at rest when it begins to act, whatever the recording has before, so the straight line is that of
// what acts. It is taken off all samples, since they are joined by straight lines.
Recording corrected_from(double from, const Recording& recording) {
  const std::vector<double>& times = recording.times();
  if (from <= times.front() || from >= times.back()) return recording.corrected();
  const Recording part = part_after(from, recording), flat = part.corrected();
  const double at_from = part.values().front() - flat.values().front();
  const double rise = (part.values().back() - flat.values().back() - at_from) / part.duration();
  std::vector<double> values = recording.values();
  for (std::size_t i = 0; i < values.size(); ++i) values[i] -= at_from + rise * (times[i] - from);
  return {recording.name(), times, std::move(values)};
}

class RecordReader {
 public:
  RecordReader(const RecordRequest& request, const std::string& place)
      : request_(request), place_(place + ": " + shown(request.file.filename().string())), stream_(open()) {}

  Recording read() {
    read_header();
    while (next_line()) read_sample();
    if (times_.size() < 2) fail(place_, fmt::format("of {} samples", times_.size()), "at least two");
    try {
      Recording recording(request_.file.filename().string(), std::move(times_), std::move(values_));
      return request_.correct_baseline ? corrected_from(request_.acts_from, recording) : recording;
    } catch (const InputError& error) {
      fail(place_ + ", " + error.field(), error.value(), error.expected());
    }
  }

 private:
  [[noreturn]] static void fail(const std::string& place, const std::string& value, const std::string& expected) {
    throw InputError("", place, value, expected);
  }
  [[nodiscard]] std::string here() const { return fmt::format("{} line {}", place_, line_number_); }
  [[nodiscard]] std::string here(std::size_t column) const {
    return fmt::format("{}, column \"{}\"", here(), shown(columns_[column].name));
  }

  [[nodiscard]] std::ifstream open() const {
    constexpr const char* expected = "a CSV file with a header and columns of time and value";
    const std::string path = shown(std::filesystem::absolute(request_.file).lexically_normal().string());
    if (const std::string why = why_unreadable(request_.file, most_input_bytes); !why.empty())
      fail(place_, why + " (" + path + ")", expected);
    std::ifstream stream(request_.file, std::ios::binary);
    if (!stream) fail(place_, "not readable (" + path + ")", expected);
    return stream;
  }

  // The next line that says something, trimmed but for tabs, which may separate empty cells.
  bool next_line() {
    while (true) {
      ++line_number_;
      stream_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
      if (stream_.bad()) fail(here(), "not readable", "text");
      if (stream_.gcount() == 0) return false;
      if (stream_.fail()) fail(here(), fmt::format("longer than {} bytes", longest_line - 1), "a row of a CSV file");
      const auto length = static_cast<std::size_t>(stream_.gcount()) - (stream_.eof() ? 0 : 1);
      line_ = trimmed({buffer_.data(), length}, " \r");
      if (line_number_ == 1 && line_.starts_with("\xEF\xBB\xBF")) line_ = trimmed(line_.substr(3), " \r");
      if (!trimmed(line_).empty() && line_.front() != '#') return true;
    }
  }

  void read_header() {
    if (!next_line()) fail(place_, "empty", "a header and rows of time and value");
    if (is_utf16(line_)) fail(place_, utf16_text, save_as_utf8);
    for (const char candidate : {',', ';', '\t'})
      if (line_.find(candidate) != std::string_view::npos) {
        separator_ = candidate;
        break;
      }
    for (const std::string_view cell : cells_of(line_, separator_)) columns_.push_back(column_of(cell));
    while (columns_.size() > 1 && columns_.back().name.empty()) columns_.pop_back();
    const bool has_numbers = std::any_of(columns_.begin(), columns_.end(),
                                         [](const Column& column) { return !std::isnan(number_in(column.name)); });
    if (has_numbers) fail(here(), fmt::format("\"{}\"", shown(line_)), "a header with the names of the columns");
    time_column_ = request_.time.empty() ? 0 : find(request_.time);
    value_column_ = request_.value.empty() ? only_value() : find(request_.value);
    if (time_column_ == value_column_) fail(here(), "a header with one column for time and value", "two columns");
    time_unit_ = unit(request_.time_unit, Dimension::time, time_column_);
    value_unit_ = unit(request_.value_unit, request_.dimension, value_column_);
  }

  [[nodiscard]] std::string names() const {
    constexpr std::size_t most_listed = 8;
    std::string list;
    for (std::size_t i = 0; i < std::min(columns_.size(), most_listed); ++i)
      list += fmt::format("{}\"{}\"", i > 0 ? ", " : "", shown(columns_[i].name));
    return columns_.size() > most_listed ? list + ", ..." : list;
  }

  [[nodiscard]] std::size_t find(const std::string& name) const {
    const auto same = [&name](const Column& column) { return column.name == name; };
    const auto found = std::find_if(columns_.begin(), columns_.end(), same);
    if (found == columns_.end()) fail(here(), "a header of " + names(), fmt::format("a column \"{}\"", shown(name)));
    if (std::any_of(found + 1, columns_.end(), same))
      fail(here(), "a header of " + names(), fmt::format("one column \"{}\"", shown(name)));
    return static_cast<std::size_t>(found - columns_.begin());
  }

  [[nodiscard]] std::size_t only_value() const {
    if (columns_.size() == 2) return 1 - std::min<std::size_t>(time_column_, 1);
    fail(here(), "a header of " + names(), "two columns, or \"value\" in the scene to say which one to take");
  }

  // By name in the scene or in the header; both may say it, but not differ, unless the scene says that there is none.
  [[nodiscard]] Unit unit(const std::string& wanted, Dimension dimension, std::size_t column) const {
    const std::string& written = columns_[column].unit;
    if (!wanted.empty() && !written.empty() && wanted != written && wanted != no_unit)
      fail(here(column), fmt::format("in \"{}\"", shown(written)),
           fmt::format("\"{}\" as the scene says", shown(wanted)));
    const std::string& symbol = wanted.empty() ? written : wanted;
    if (symbol.empty() || symbol == no_unit) return {"", 1, 1};
    for (const Unit& unit : units(dimension))
      if (unit.symbol == symbol) return unit;
    fail(here(column), fmt::format("in \"{}\"", shown(symbol)), "a unit of " + std::string(to_string(dimension)));
  }

  void read_sample() {
    if (times_.size() == request_.most_samples)
      fail(here(), "one too many", fmt::format("at most {} samples", request_.most_samples));
    const std::vector<std::string_view> cells = cells_of(line_, separator_);
    refuse_more_than_header(cells);
    const double time = value_in(cells, time_column_, time_unit_);
    if (!times_.empty() && !(time > times_.back()))
      fail(here(time_column_), fmt::format("\"{}\"", shown(cells[time_column_])), "a later time than the row before");
    const double value = request_.scale * value_in(cells, value_column_, value_unit_);
    if (!std::isfinite(value)) fail(here(value_column_), "too large with its unit and scale", "a finite number");
    times_.push_back(time);
    values_.push_back(value);
  }

  // Decimal commas between separating ones would be read as other numbers. Separators that end a row say nothing.
  void refuse_more_than_header(const std::vector<std::string_view>& cells) const {
    const auto last = std::find_if(cells.rbegin(), cells.rend(), [](std::string_view cell) { return !cell.empty(); });
    const auto filled = static_cast<std::size_t>(cells.rend() - last);
    if (filled > columns_.size())
      fail(here(), fmt::format("of {} columns", filled), fmt::format("{} as in the header", columns_.size()));
  }

  [[nodiscard]] double value_in(const std::vector<std::string_view>& cells, std::size_t column, const Unit& unit) {
    if (column >= cells.size()) fail(here(column), "missing", "a finite number");
    const double number = decimal_in(cells[column], column) * unit.numerator / unit.denominator;
    if (!std::isfinite(number)) fail(here(column), fmt::format("\"{}\"", shown(cells[column])), "a finite number");
    return number;
  }

  // A number with a decimal point or, where commas do not part columns, a decimal comma. It is the same in all of a
  // file: commas in a file with decimal points part thousands.
  [[nodiscard]] double decimal_in(std::string_view cell, std::size_t column) {
    const auto mark = cell.find_first_of(separator_ == ',' ? "." : ".,");
    if (mark == std::string_view::npos) return number_in(cell);
    if (decimal_mark_ == 0) decimal_mark_ = cell[mark];
    if (cell[mark] != decimal_mark_)
      fail(here(column), fmt::format("\"{}\"", shown(cell)),
           fmt::format("a finite number with \"{}\" before its decimals, as those before it", decimal_mark_));
    if (cell[mark] == '.') return number_in(cell);
    std::string text(cell);
    text[mark] = '.';
    return number_in(text);
  }

  const RecordRequest& request_;
  std::string place_;
  std::ifstream stream_;
  std::array<char, longest_line> buffer_{};
  std::string_view line_;
  std::size_t line_number_ = 0;
  char separator_ = ',';
  char decimal_mark_ = 0;  // 0: no number had one yet
  std::vector<Column> columns_;
  std::size_t time_column_ = 0, value_column_ = 0;
  Unit time_unit_{"", 1, 1}, value_unit_{"", 1, 1};
  std::vector<double> times_, values_;
};

}  // namespace

Recording read_record(const RecordRequest& request, const std::string& place) {
  return RecordReader(request, place).read();
}

}  // namespace dda
