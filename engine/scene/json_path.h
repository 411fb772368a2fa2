// How errors name a place in a scene and show what stands there.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace dda {

// loads[0].force and the like; a key that is no plain word is quoted: materials["soft rock"].
std::string member_path(const std::string& parent, std::string_view key);
std::string item_path(const std::string& parent, std::size_t index);

// `text` on one line of printable ASCII or whole UTF-8 characters, cut to what a sentence bears.
std::string shown(std::string_view text);

// A JSON value as compact text, in the same way.
std::string shown_value(const nlohmann::json& value);

}  // namespace dda
