#include "engine/core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace dda {
namespace {

constexpr std::size_t longest_quote = 400;  // bytes
constexpr std::size_t longest_path = 1000;  // of a file, which damaged files may name as well

// Part of a sentence: what is quoted from a damaged file may hold anything, and have any length.
std::string readable(std::string text, std::size_t longest = longest_quote) {
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  if (text.size() <= longest) return text;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // not within a character
  return text.substr(0, end) + "...";
}

std::string sentence(const std::string& file, const std::string& field, const std::string& value,
                     const std::string& expected) {
  return (file.empty() ? "" : readable(file, longest_path) + ": ") + readable(field) + " is " + readable(value) +
         ", expected " + expected;
}

}  // namespace

InputError::InputError(const std::string& file, std::string field, std::string value, std::string expected)
    : std::runtime_error(sentence(file, field, value, expected)),
      field_(std::move(field)),
      value_(std::move(value)),
      expected_(std::move(expected)) {}

InputError InputError::in_file(const std::string& file) const { return {file, field_, value_, expected_}; }

std::string written(const Vec2& point) { return fmt::format("({:.9g}, {:.9g}) m", point.x(), point.y()); }

}  // namespace dda
