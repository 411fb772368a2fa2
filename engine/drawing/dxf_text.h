// Blocks as DXF.
#pragma once

#include <string>

#include "engine/drawing/write_blocks.h"

namespace dda {

std::string dxf_text(const BlockDrawing& drawing);

}  // namespace dda
