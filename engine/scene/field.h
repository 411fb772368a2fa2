// One place of a scene document: its value in SI, and errors that name it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/builder/names.h"
#include "engine/core/quantity.h"
#include "engine/core/types.h"

namespace dda {

class Field {
 public:
  // `value` must outlive the field.
  Field(const nlohmann::json& value, std::string path) : value_(&value), path_(std::move(path)) {}

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] bool is_text() const;
  [[nodiscard]] bool is_array() const;
  [[nodiscard]] bool is_object() const;

  [[nodiscard]] bool has(std::string_view key) const;
  [[nodiscard]] Field at(std::string_view key) const;  // throws when missing
  [[nodiscard]] std::optional<Field> find(std::string_view key) const;
  [[nodiscard]] std::vector<Field> items() const;                            // of an array
  [[nodiscard]] std::vector<std::pair<std::string, Field>> members() const;  // of an object

  // A JSON number, in SI, or text with a unit of `dimension`. All throw InputError for a value of another kind.
  [[nodiscard]] double quantity(Dimension dimension) const;
  [[nodiscard]] double positive(Dimension dimension) const;
  [[nodiscard]] double not_negative(Dimension dimension) const;
  [[nodiscard]] double within(double lowest, double highest) const;  // dimensionless
  [[nodiscard]] Vec2 vector(Dimension dimension) const;              // [x, y]
  [[nodiscard]] Vec2 vector(Dimension first, Dimension second) const;
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::string name() const;  // text that can stand in a CSV header: no control characters, quotes, commas
  [[nodiscard]] bool truth() const;
  [[nodiscard]] int whole_number() const;

  // The position of the text in `words`.
  [[nodiscard]] std::size_t choice(const std::vector<std::string>& words) const;
  [[nodiscard]] int choice(const Names& names) const;  // the first that is called so

  // "PATH is VALUE, expected EXPECTED".
  [[noreturn]] void fail(const std::string& expected) const;
  [[noreturn]] void fail(const std::string& value, const std::string& expected) const;

 private:
  const nlohmann::json* value_;
  std::string path_;
};

// The value of `key` read by `read`, or `otherwise`.
template <typename Value, typename Read>
Value value_or(const Field& parent, std::string_view key, Value otherwise, Read read) {
  const std::optional<Field> field = parent.find(key);
  return field ? static_cast<Value>(read(*field)) : otherwise;
}

}  // namespace dda
