// The blocks of a cut scene as a drawing.
#pragma once

#include "engine/drawing/write_blocks.h"
#include "engine/scene/cut_scene.h"

namespace dda {

// Blocks with their groups and materials, and all joints between them, the default one too.
BlockDrawing drawing_of_blocks(const CutScene& scene);

}  // namespace dda
