#include "engine/scene/json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/core/error.h"
#include "engine/scene/json_path.h"
#include "engine/scene/json_tracker.h"

namespace dda {
namespace {

using nlohmann::json;

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

[[noreturn]] void throw_syntax_error(std::string_view text, const json::parse_error& error,
                                     const JsonTracker& tracker) {
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
[[noreturn]] void throw_overflow(const json::out_of_range& error, const JsonTracker& tracker) {
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
  JsonTracker tracker(document);
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
