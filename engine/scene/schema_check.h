// A scene document against scene.schema.json.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace dda {

// Throws InputError (without a file) for the most helpful of the violations.
void check_schema(const nlohmann::json& scene);

}  // namespace dda
