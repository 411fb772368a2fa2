#include "engine/drawing/dxf_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>

namespace dda {
namespace {

constexpr std::uint32_t first_high = 0xD800;  // surrogates, as UTF-16 has them: ten bits each
constexpr std::uint32_t first_low = 0xDC00;
constexpr std::uint32_t after_low = 0xE000;
constexpr std::uint32_t beyond_16_bits = 0x10000;

// The character that begins `text`, which becomes shorter by it.
std::uint32_t take_character(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
  const std::uint32_t first = byte(0);
  const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  std::uint32_t character = length == 1 ? first : first & (0x7FU >> length);
  for (std::size_t i = 1; i < length && i < text.size(); ++i) character = character << 6U | (byte(i) & 0x3FU);
  text.remove_prefix(std::min(length, text.size()));
  return character;
}

void append_utf8(std::uint32_t character, std::string& text) {
  const auto add = [&](std::uint32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
  const auto follow = [&](unsigned shift) { add(0x80U | (character >> shift & 0x3FU)); };
  if (character < 0x80) return add(character);
  if (character < 0x800) {
    add(0xC0U | character >> 6U);
  } else {
    if (character < beyond_16_bits) {
      add(0xE0U | character >> 12U);
    } else {
      add(0xF0U | character >> 18U);
      follow(12);
    }
    follow(6);
  }
  follow(0);
}

// The code at the beginning of "\U+00F6...".
std::optional<std::uint32_t> code_at(std::string_view text) {
  constexpr std::size_t length = 7;
  if (text.size() < length || text.substr(0, 3) != "\\U+") return std::nullopt;
  std::uint32_t code = 0;
  const auto [end, error] = std::from_chars(text.data() + 3, text.data() + length, code, 16);
  if (error != std::errc() || end != text.data() + length) return std::nullopt;
  return code;
}

// The same, with both codes of a character beyond 16 bits; `text` becomes shorter by what it takes.
std::optional<std::uint32_t> take_code(std::string_view& text) {
  const auto code = code_at(text);
  if (!code) return std::nullopt;
  constexpr std::size_t length = 7;
  text.remove_prefix(length);
  if (*code < first_high || *code >= after_low) return code;
  const auto low = code_at(text);
  if (*code >= first_low || !low || *low < first_low || *low >= after_low)
    return static_cast<std::uint32_t>(0x3F);  // a question mark
  text.remove_prefix(length);
  return beyond_16_bits + ((*code - first_high) << 10U) + (*low - first_low);
}

}  // namespace

std::string dxf_name(std::string_view name) {
  constexpr std::size_t longest = 31;
  std::string text;
  for (const char c : name.substr(0, longest)) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    text += letter || c == '-' ? c : '_';
  }
  return text;
}

std::string dxf_escaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::uint32_t character = take_character(text);
    if (character >= ' ' && character < 0x7F && character != '\\')
      result += static_cast<char>(character);
    else if (character < beyond_16_bits)
      result += fmt::format("\\U+{:04X}", character);
    else
      result += fmt::format("\\U+{:04X}\\U+{:04X}", first_high + ((character - beyond_16_bits) >> 10U),
                            first_low + (character & 0x3FFU));
  }
  return result;
}

std::string dxf_unescaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    if (const auto code = take_code(text)) {
      append_utf8(*code, result);
    } else {
      result += text.front();
      text.remove_prefix(1);
    }
  }
  return result;
}

}  // namespace dda
