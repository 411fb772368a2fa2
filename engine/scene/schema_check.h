// A scene document against scene.schema.json.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace dda {

// Throws InputError (without a file) for the most helpful of the violations.
void check_schema(const nlohmann::json& scene);

// The same; the many lines of a rock are shared among threads, for which they leave the scene and come back.
void check_schema_of_many(nlohmann::json& scene);

}  // namespace dda
