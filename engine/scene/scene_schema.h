// The published JSON Schema (draft 7) of scene files, scene.schema.json as text.
#pragma once

#include <string_view>

namespace dda {

std::string_view scene_schema();

}  // namespace dda
