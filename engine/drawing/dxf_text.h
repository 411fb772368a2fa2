// Blocks as DXF.
#pragma once

#include <string>

#include "engine/drawing/block_drawing.h"

namespace dda {

std::string dxf_text(const BlockDrawing& drawing);

}  // namespace dda
