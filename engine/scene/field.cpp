#include "engine/scene/field.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/scene/json_path.h"
#include "engine/scene/nearest_word.h"

namespace dda {
namespace {

// Each word once: names of blocks are those of groups too.
std::string quoted_list(const std::vector<std::string>& words) {
  constexpr std::size_t most_listed = 8;
  std::vector<std::string> listed;
  for (const std::string& word : words) {
    if (std::find(listed.begin(), listed.end(), word) != listed.end()) continue;
    if (listed.size() == most_listed) return fmt::format("\"{}\", ...", fmt::join(listed, "\", \""));
    listed.push_back(word);
  }
  return fmt::format("\"{}\"", fmt::join(listed, "\", \""));
}

}  // namespace

bool Field::is_text() const { return value_->is_string(); }
bool Field::is_array() const { return value_->is_array(); }
bool Field::is_object() const { return value_->is_object(); }

bool Field::has(std::string_view key) const { return value_->is_object() && value_->contains(key); }

std::optional<Field> Field::find(std::string_view key) const {
  if (!has(key)) return {};
  return Field((*value_)[std::string(key)], member_path(path_, key));
}

Field Field::at(std::string_view key) const {
  if (std::optional<Field> field = find(key)) return *field;
  throw InputError("", member_path(path_, key), "missing", "a value");
}

std::vector<Field> Field::items() const {
  if (!value_->is_array()) fail("an array");
  std::vector<Field> fields;
  fields.reserve(value_->size());
  for (std::size_t i = 0; i < value_->size(); ++i) fields.emplace_back((*value_)[i], item_path(path_, i));
  return fields;
}

std::vector<std::pair<std::string, Field>> Field::members() const {
  if (!value_->is_object()) fail("an object");
  std::vector<std::pair<std::string, Field>> fields;
  for (const auto& [key, value] : value_->items()) fields.emplace_back(key, Field(value, member_path(path_, key)));
  return fields;
}

double Field::quantity(Dimension dimension) const {
  if (value_->is_string()) return parse_quantity(value_->get_ref<const std::string&>(), dimension, path_);
  if (!value_->is_number()) fail(expected_quantity(dimension));
  const auto number = value_->get<double>();
  if (!std::isfinite(number)) fail("a finite number");
  return number;
}

double Field::positive(Dimension dimension) const {
  const double value = quantity(dimension);
  if (value <= 0)
    fail(fmt::format("a positive {}", dimension == Dimension::dimensionless ? "number" : to_string(dimension)));
  return value;
}

double Field::not_negative(Dimension dimension) const {
  const double value = quantity(dimension);
  if (value < 0) fail("zero or more");
  return value;
}

double Field::within(double lowest, double highest) const {
  const double value = quantity(Dimension::dimensionless);
  if (value < lowest || value > highest) fail(fmt::format("a number from {:.6g} to {:.6g}", lowest, highest));
  return value;
}

Vec2 Field::vector(Dimension dimension) const { return vector(dimension, dimension); }

Vec2 Field::vector(Dimension first, Dimension second) const {
  if (!value_->is_array() || value_->size() != 2) fail("two numbers [x, y]");
  return {Field((*value_)[0], item_path(path_, 0)).quantity(first),
          Field((*value_)[1], item_path(path_, 1)).quantity(second)};
}

std::string Field::text() const {
  if (!value_->is_string()) fail("text");
  return value_->get<std::string>();
}

std::string Field::name() const {
  std::string result = text();
  for (const char c : result) {
    const bool breaks_a_table = static_cast<unsigned char>(c) < ' ' || c == '\x7f' || c == '"' || c == ',' || c == ';';
    if (breaks_a_table) fail("a name without commas, semicolons, quotes and control characters");
  }
  if (result.empty() || result.front() == ' ' || result.back() == ' ') fail("a name without blanks at its ends");
  return result;
}

bool Field::truth() const {
  if (!value_->is_boolean()) fail("true or false");
  return value_->get<bool>();
}

int Field::whole_number() const {
  const double value = quantity(Dimension::dimensionless);
  const bool whole = value == std::floor(value) && std::abs(value) <= std::numeric_limits<int>::max();
  if (!whole) fail("a whole number");
  return static_cast<int>(value);
}

std::size_t Field::choice(const std::vector<std::string>& words) const {
  const std::string word = text();
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == word) return i;
  }
  const std::string meant = nearest_word(word, words);
  fail(fmt::format("{}{}{}", words.size() == 1 ? "" : "one of ", quoted_list(words),
                   meant.empty() || words.size() == 1 ? "" : fmt::format(" (perhaps \"{}\")", meant)));
}

int Field::choice(const Names& names) const {
  if (const auto index = names.find(text())) return *index;
  return static_cast<int>(choice(names.all()));  // throws, as none is it
}

void Field::fail(const std::string& expected) const { fail(shown_value(*value_), expected); }

void Field::fail(const std::string& value, const std::string& expected) const {
  throw InputError("", path_, value, expected);
}

}  // namespace dda
