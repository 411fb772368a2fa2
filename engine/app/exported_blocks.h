// The blocks of a cut scene as a drawing.
#pragma once

#include "engine/drawing/write_blocks.h"
#include "engine/scene/cut_scene.h"

namespace dda {

// Blocks on layers named as their groups, joints on "joint NAME".
BlockDrawing drawing_of_blocks(const CutScene& scene);

}  // namespace dda
