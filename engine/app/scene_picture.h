// A picture (SVG) of a scene before anything moves: blocks in the colour of their group and material, joints in that of
// theirs, what is taken out, and what holds, loads and supports them.
#pragma once

#include <optional>
#include <string>

#include "engine/geometry/box.h"
#include "engine/scene/scene_parts.h"

namespace dda {

// `part` (m) of the plane, or all blocks.
std::string scene_picture(const SceneParts& scene, const std::optional<Box>& part);

}  // namespace dda
