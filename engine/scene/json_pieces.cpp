#include "engine/scene/json_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace dda {
namespace {

bool is_plain(char c) { return c >= ' ' && c < '\x7f' && c != '"' && c != '\\'; }

}  // namespace

// The library's own function, as others choose other digits where two are equally short. Its numbers have at most 17
// digits, a sign, a point and an exponent of three digits: it asks for 64 characters.
void append_json_number(double value, std::string& text) {
  if (!std::isfinite(value)) {
    text += "null";
    return;
  }
  std::array<char, 64> digits{};
  text.append(digits.data(), nlohmann::detail::to_chars(digits.data(), digits.data() + digits.size(), value));
}

void append_json_text(std::string_view value, std::string& text) {
  if (!std::ranges::all_of(value, is_plain)) {
    text += nlohmann::json(value).dump();
    return;
  }
  text += '"';
  text += value;
  text += '"';
}

}  // namespace dda
