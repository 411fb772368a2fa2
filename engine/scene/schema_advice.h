// Words for a violation of the schema: which key, which value, what was expected.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/core/error.h"

namespace dda {

// `place` is the JSON pointer of the node in `scene` that violates `schema`.
InputError schema_violation(const nlohmann::json& schema, const nlohmann::json& scene, const std::string& place);

}  // namespace dda
