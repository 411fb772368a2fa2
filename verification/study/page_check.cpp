#include "verification/study/page_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>

namespace verify {
namespace {

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

// The line up to its first number, the number as text with its sign, and the rest; without a number all is in front.
struct Cut {
  std::string_view front, number, rest;
};

Cut cut(std::string_view line) {
  std::size_t start = 0;
  while (start < line.size() && !is_digit(line[start])) ++start;
  std::size_t end = start;
  const auto take_digits = [&] {
    while (end < line.size() && is_digit(line[end])) ++end;
  };
  take_digits();
  if (end + 1 < line.size() && line[end] == '.' && is_digit(line[end + 1])) {
    ++end;
    take_digits();
  }
  if (start > 1 && start < end && line[start - 2] == ' ' && (line[start - 1] == '+' || line[start - 1] == '-')) --start;
  return {line.substr(0, start), line.substr(start, end - start), line.substr(end)};
}

double value_of(std::string_view number) {
  if (number.starts_with('+')) number.remove_prefix(1);
  double value = 0;
  std::from_chars(number.data(), number.data() + number.size(), value);
  return value;
}

std::size_t decimals_of(std::string_view number) {
  const std::size_t point = number.find('.');
  return point == std::string_view::npos ? 0 : number.size() - point - 1;
}

bool agree(std::string_view printed, std::string_view made, int last_digits) {
  while (true) {
    const Cut was = cut(printed), is = cut(made);
    if (was.front != is.front || was.number.empty() != is.number.empty()) return false;
    if (was.number.empty()) return true;
    const std::size_t decimals = decimals_of(was.number);
    const double last_digit = std::pow(10, -static_cast<double>(decimals));
    if (decimals != decimals_of(is.number) ||
        std::abs(value_of(was.number) - value_of(is.number)) > (last_digits + 0.01) * last_digit)
      return false;
    printed = was.rest;
    made = is.rest;
  }
}

std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

}  // namespace

std::vector<std::string> stale_lines(std::string_view printed, std::string_view made, int last_digits) {
  std::vector<std::string> found;
  while (!printed.empty() || !made.empty()) {
    const std::string_view was = take_line(printed), is = take_line(made);
    if (!agree(was, is, last_digits)) found.push_back(fmt::format("\"{}\" is printed, it should be \"{}\"", was, is));
  }
  return found;
}

}  // namespace verify
