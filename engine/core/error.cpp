#include "engine/core/error.h"

#include <fmt/format.h>

#include <utility>

namespace dda {
namespace {

std::string sentence(const std::string& file, const std::string& field, const std::string& value,
                     const std::string& expected) {
  return (file.empty() ? "" : file + ": ") + field + " is " + value + ", expected " + expected;
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
