// Numbers and text as the JSON library writes them, without a document around them: a list of a million entries is a
// hundred million small objects for the library, and takes ten times as long.
#pragma once

#include <string>
#include <string_view>

#include "engine/core/types.h"

namespace dda {

// The same digits as in a document; null where not finite, which JSON cannot say.
void append_json_number(double value, std::string& text);

// In quotes. Throws nlohmann::json::type_error for bytes that are no UTF-8.
void append_json_text(std::string_view value, std::string& text);

}  // namespace dda
