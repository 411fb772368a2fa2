#include "engine/scene/json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/scene/json_path.h"

namespace dda {
namespace {

using nlohmann::json;

// Deeper than any scene; keeps recursive walks over the document off the end of the stack.
constexpr std::size_t deepest_nesting = 32;

// The keys of an object, most of which have few.
class Keys {
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
class Tracker {
 public:
  explicit Tracker(json& document) : builder_(document) {}

  bool null() { return builder_.null() && next_item(); }
  bool boolean(bool value) { return builder_.boolean(value) && next_item(); }
  bool number_integer(json::number_integer_t value) { return builder_.number_integer(value) && next_item(); }
  bool number_unsigned(json::number_unsigned_t value) { return builder_.number_unsigned(value) && next_item(); }
  bool number_float(json::number_float_t value, const std::string& text) {
    return builder_.number_float(value, text) && next_item();
  }
  bool string(std::string& value) { return builder_.string(value) && next_item(); }
  bool binary(json::binary_t& value) { return builder_.binary(value) && next_item(); }
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
    Keys keys;
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

  nlohmann::detail::json_sax_dom_parser<json> builder_;
  std::array<Level, deepest_nesting> levels_;  // of which the first are open, and the others keep their memory
  std::size_t depth_ = 0;
};

struct Position {
  std::size_t line;
  std::size_t column;
};

Position position_of(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, byte);
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  return {static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1, byte - line_start + 1};
}

bool ends_word(char c) { return c == ',' || c == ':' || c == '{' || c == '}' || c == '[' || c == ']' || c <= ' '; }

// The word around `byte`, or the single character there.
std::string_view word_at(std::string_view text, std::size_t byte) {
  std::size_t first = byte;
  std::size_t last = byte;
  while (first > 0 && !ends_word(text[first]) && !ends_word(text[first - 1])) --first;
  while (last < text.size() && !ends_word(text[last])) ++last;
  return text.substr(first, std::max(last, byte + 1) - first);
}

bool is_not_a_finite_number(std::string_view word) {
  std::string lower(word.substr(0, 20));
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (!lower.empty() && (lower[0] == '-' || lower[0] == '+')) lower.erase(0, 1);
  return lower == "nan" || lower == "inf" || lower == "infinity";
}

// Bytes that may not be whole characters are not repeated.
std::string quoted_word(std::string_view word) {
  std::string ascii(word);
  for (char& c : ascii) {
    if (static_cast<unsigned char>(c) >= 0x80) c = '?';
  }
  return fmt::format("\"{}\"", shown(ascii));
}

// The parser's own words on what it wanted, or that the text is not UTF-8.
std::string advice(std::string_view parser_message) {
  if (parser_message.find("UTF-8") != std::string_view::npos) return "text in UTF-8";
  const std::size_t at = parser_message.rfind("expected ");
  const bool says = at != std::string_view::npos && (at == 0 || parser_message[at - 1] == ' ');
  return says ? fmt::format("valid JSON: {}", parser_message.substr(at + 9)) : "valid JSON";
}

[[noreturn]] void throw_syntax_error(std::string_view text, const json::parse_error& error, const Tracker& tracker) {
  const std::size_t byte = error.byte > 0 ? error.byte - 1 : 0;
  const auto [line, column] = position_of(text, std::min(byte, text.size()));
  const std::string path = tracker.path();
  const std::string field = fmt::format("{} (line {}, column {})", path.empty() ? "the scene" : path, line, column);
  if (byte >= text.size()) throw InputError("", field, "cut short: the text ends here", advice(error.what()));
  const std::string_view word = word_at(text, byte);
  throw InputError("", field, quoted_word(word),
                   is_not_a_finite_number(word) ? "a finite number" : advice(error.what()));
}

// The parser quotes the number in its message: ... parsing '1e400'.
[[noreturn]] void throw_overflow(const json::out_of_range& error, const Tracker& tracker) {
  const std::string_view message = error.what();
  const std::size_t first = std::min(message.find('\''), message.size());
  throw InputError("", tracker.path(), shown(message.substr(first, message.rfind('\'') - first + 1)),
                   "a finite number");
}

}  // namespace

nlohmann::json parse_json(std::string_view text) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    throw InputError("", "the scene", "empty", "a JSON object");
  }
  json document;
  Tracker tracker(document);
  try {
    json::sax_parse(text, &tracker);
    return document;
  } catch (const json::parse_error& error) {
    throw_syntax_error(text, error, tracker);
  } catch (const json::out_of_range& error) {
    throw_overflow(error, tracker);
  }
}

}  // namespace dda
