// A picture (SVG) of cut rock: blocks in the colour of their group and material, joints in that of theirs.
#pragma once

#include <string>

#include "engine/scene/cut_scene.h"

namespace dda {

std::string cut_picture(const CutScene& scene);

}  // namespace dda
