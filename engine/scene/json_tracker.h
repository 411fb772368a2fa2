// Where the parser of the JSON library is in a text, while the document is made.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/scene/json_path.h"

namespace dda {

// Deeper than any scene; keeps recursive walks over the document off the end of the stack.
inline constexpr std::size_t deepest_nesting = 32;

// The keys of an object, most of which have few.
class KeysOfObject {
 public:
  void clear() {
    first_.clear();
    others_.clear();
  }

  // Whether it is new.
  bool insert(const std::string& key) {
    if (std::ranges::find(first_, key) != first_.end()) return false;
    if (first_.size() == few) return others_.insert(key).second;
    first_.push_back(key);
    return true;
  }

 private:
  static constexpr std::size_t few = 8;
  std::vector<std::string> first_;
  std::set<std::string> others_;
};

// Follows the parser through the document: where it is, and which keys the open objects have had, while the library's
// own builder makes the document. The names of the functions are those that the library calls; all go on by returning
// true. (The library's parser with a callback would do for less, but it looks through all items before at the end of
// each.)
class JsonTracker {
 public:
  explicit JsonTracker(nlohmann::json& document) : builder_(document) {}

  bool null() { return builder_.null() && next_item(); }
  bool boolean(bool value) { return builder_.boolean(value) && next_item(); }
  bool number_integer(nlohmann::json::number_integer_t value) { return builder_.number_integer(value) && next_item(); }
  bool number_unsigned(nlohmann::json::number_unsigned_t value) {
    return builder_.number_unsigned(value) && next_item();
  }
  bool number_float(nlohmann::json::number_float_t value, const std::string& text) {
    return builder_.number_float(value, text) && next_item();
  }
  bool string(std::string& value) { return builder_.string(value) && next_item(); }
  bool binary(nlohmann::json::binary_t& value) { return builder_.binary(value) && next_item(); }
  bool start_object(std::size_t size) { return open(false) && builder_.start_object(size); }
  bool start_array(std::size_t size) { return open(true) && builder_.start_array(size); }
  bool end_object() { return builder_.end_object() && close(); }
  bool end_array() { return builder_.end_array() && close(); }

  bool key(std::string& key) {
    Level& level = levels_[depth_ - 1];
    level.key = key;
    level.has_key = true;
    if (!level.keys.insert(key)) throw InputError("", path(), "given twice", "each key once in an object");
    return builder_.key(key);
  }

  template <typename Error>
  bool parse_error(std::size_t, const std::string&, const Error& error) {
    throw error;
  }

  [[nodiscard]] std::string path() const {
    std::string path;
    for (std::size_t i = 0; i < depth_; ++i) {
      const Level& level = levels_[i];
      if (level.is_array) {
        path = item_path(path, level.index);
      } else if (level.has_key) {
        path = member_path(path, level.key);
      }
    }
    return path;
  }

 private:
  struct Level {
    bool is_array = false;
    std::size_t index = 0;
    bool has_key = false;
    std::string key;
    KeysOfObject keys;
  };

  bool open(bool is_array) {
    if (depth_ >= deepest_nesting) {
      throw InputError("", path().substr(0, 80), "nested too deep", fmt::format("at most {} levels", deepest_nesting));
    }
    Level& level = levels_[depth_++];
    level.is_array = is_array;
    level.index = 0;
    level.has_key = false;
    level.keys.clear();
    return true;
  }

  bool close() {
    --depth_;
    return next_item();
  }

  bool next_item() {
    if (depth_ > 0 && levels_[depth_ - 1].is_array) ++levels_[depth_ - 1].index;
    return true;
  }

  nlohmann::detail::json_sax_dom_parser<nlohmann::json> builder_;
  std::array<Level, deepest_nesting> levels_;  // of which the first are open, and the others keep their memory
  std::size_t depth_ = 0;
};

}  // namespace dda
