#include "engine/drawing/number_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/error.h"
#include "engine/drawing/line_drawing.h"
#include "engine/drawing/number_text.h"

namespace dda {
namespace {

constexpr int most_counted = 1'000'000;  // of anything in a file; also the largest number of a material
constexpr std::string_view between_numbers = " \t\r\n,";
constexpr std::size_t most_shown = 40;  // characters of a word in a message

}  // namespace

std::string NumberList::here() const { return fmt::format("{} line {}", name_, line_); }

bool NumberList::at_end() {
  skip_blanks();
  return rest_.empty();
}

std::string_view NumberList::word() {
  skip_blanks();
  const std::size_t end = std::min(rest_.find_first_of(between_numbers), rest_.size());
  const std::string_view found = rest_.substr(0, end);
  rest_.remove_prefix(end);
  return found;
}

double NumberList::number(const char* what) {
  if (at_end()) throw InputError("", here(), fmt::format("the end of the file, before {}", what), "all its numbers");
  const std::string_view found = word();
  const auto number = number_in<double>(found);
  if (!number)
    throw InputError("", here(), fmt::format("\"{}\" for {}", readable(found.substr(0, most_shown)), what),
                     "a finite number");
  return *number;
}

int NumberList::whole(const char* what, int least) {
  const double value = number(what);
  if (value != std::floor(value) || value < least || value > most_counted)
    throw InputError("", here(), fmt::format("{:g} for {}", value, what),
                     fmt::format("a whole number from {} to {}", least, most_counted));
  return static_cast<int>(value);
}

void NumberList::expect_end(const char* behind, const char* expected) {
  if (at_end()) return;
  throw InputError("", here(), fmt::format("\"{}\" behind {}", readable(word()).substr(0, most_shown), behind),
                   expected);
}

void NumberList::skip_blanks() {
  while (!rest_.empty() && between_numbers.find(rest_.front()) != std::string_view::npos) {
    if (rest_.front() == '\n') ++line_;
    rest_.remove_prefix(1);
  }
}

}  // namespace dda
