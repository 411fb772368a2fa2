// JSON text to a document, with the errors a person can act on.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace dda {

// Strict JSON (no comments, no NaN), no key twice in an object, nested at most 32 deep. Throws InputError (without a
// file) naming the field being read, line and column.
nlohmann::json parse_json(std::string_view text);

}  // namespace dda
