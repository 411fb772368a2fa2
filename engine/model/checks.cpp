#include "engine/model/checks.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/core/error.h"

namespace dda::model_checks {

// An item with a name goes by it, as its index says little where a scene generated it.
void Item::fail(std::string_view member, const std::string& value, const std::string& expected) const {
  const std::string item = name_.empty() ? fmt::format("[{}]", index_) : fmt::format(" \"{}\"", name_);
  throw InputError("", fmt::format("{}{} {}", list_, item, member), value, expected);
}

void Item::positive(std::string_view member, double value) const {
  if (!(value > 0) || !std::isfinite(value)) fail(member, fmt::format("{}", value), "a positive number");
}

void Item::not_negative(std::string_view member, double value) const {
  if (!(value >= 0) || !std::isfinite(value)) fail(member, fmt::format("{}", value), "zero or a positive number");
}

void Item::within(std::string_view member, double value, double lowest, double highest) const {
  if (value >= lowest && value <= highest) return;
  fail(member, fmt::format("{}", value), fmt::format("a number from {} to {}", lowest, highest));
}

void Item::finite(std::string_view member, double value) const {
  if (!std::isfinite(value)) fail(member, fmt::format("{}", value), "a finite number");
}

void Item::finite(std::string_view member, const Vec2& value) const {
  if (!value.allFinite()) fail(member, fmt::format("({}, {})", value.x(), value.y()), "finite numbers");
}

void Item::finite(std::string_view member, const Vec3& value) const {
  if (value.allFinite()) return;
  fail(member, fmt::format("({}, {}, {})", value.x(), value.y(), value.z()), "finite numbers");
}

void Item::index(std::string_view member, int value, std::size_t count) const {
  if (value >= 0 && static_cast<std::size_t>(value) < count) return;
  fail(member, fmt::format("{}", value), fmt::format("an index below {}", count));
}

}  // namespace dda::model_checks
