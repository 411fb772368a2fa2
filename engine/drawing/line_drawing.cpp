#include "engine/drawing/line_drawing.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <utility>

#include "engine/core/error.h"

namespace dda {
namespace {

// How many bytes the UTF-8 character at `at` has, by its first byte and those that follow; 0 where there is none.
std::size_t utf8_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || at + length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xC0) != 0x80) return 0;
  }
  const bool overlong = (first == 0xE0 && byte(at + 1) < 0xA0) || (first == 0xF0 && byte(at + 1) < 0x90);
  const bool beyond = (first == 0xED && byte(at + 1) > 0x9F) || (first == 0xF4 && byte(at + 1) > 0x8F);
  return overlong || beyond ? 0 : length;
}

void append_latin_1(unsigned char byte, std::string& text) {
  text += static_cast<char>(0xC0 | (byte >> 6));
  text += static_cast<char>(0x80 | (byte & 0x3F));
}

}  // namespace

std::string readable(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    const auto byte = static_cast<unsigned char>(text[i]);
    if (length == 0)
      append_latin_1(byte, result);
    else if (byte < 0x20 || byte == 0x7F)
      result += '?';
    else
      result += text.substr(i, length);
    i += std::max<std::size_t>(length, 1);
  }
  return result;
}

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower;
}

void take_spellings_as_one(LineDrawing& drawing) {
  std::map<std::string, std::string> first;  // by the name in lower case
  const auto take = [&](std::string& layer) {
    const std::string& name = first.try_emplace(in_lower_case(layer), layer).first->second;
    if (layer == name) return;
    drawing.other_spellings[layer] = name;
    layer = name;
  };
  for (DrawnLine& line : drawing.lines) take(line.layer);
  for (DrawnPoint& point : drawing.points) take(point.layer);
}

void Pencil::add(DrawnLine line) {
  check(line.start, line.origin);
  for (const DrawnPiece& piece : line.pieces) check(piece.end, line.origin);
  if (line.pieces.empty())
    throw InputError("", line.origin, fmt::format("a line of one point on layer \"{}\"", line.layer), "two or more");
  count(line.origin);
  drawing_.lines.push_back(std::move(line));
}

void Pencil::add(DrawnPoint point) {
  check(point.at, point.origin);
  count(point.origin);
  drawing_.points.push_back(std::move(point));
}

void Pencil::check(const Vec2& point, const std::string& origin) const {
  if (!point.allFinite() || point.cwiseAbs().maxCoeff() > farthest_drawn)
    throw InputError("", origin, "at " + written(point), "finite coordinates up to 1e12 m");
}

void Pencil::count(const std::string& origin) {
  if (drawing_.lines.size() + drawing_.points.size() >= most_drawn)
    throw InputError("", origin, "one too many", fmt::format("at most {} lines and points", most_drawn));
}

}  // namespace dda
