// A scene as it would be if none of its rock merged small or sharp blocks.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace dda {

// The text of that scene; nothing where no rock asks for merging. Throws InputError for text that is no scene.
std::optional<std::string> without_merging(std::string_view json_text);

}  // namespace dda
