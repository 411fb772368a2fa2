// Blocks as lines for dc of the original DDA, in the layout that read_dc.cpp tells.
#pragma once

#include <string>
#include <vector>

#include "engine/drawing/block_drawing.h"

namespace dda {

std::string dc_text(const BlockDrawing& drawing);

// Names of the joints that have the numbers 1, 2, ... there.
std::vector<std::string> dc_joints(const BlockDrawing& drawing);

}  // namespace dda
