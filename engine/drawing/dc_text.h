// Blocks as lines for dc of the original DDA, in the layout that read_dc.cpp tells.
#pragma once

#include <string>

#include "engine/drawing/write_blocks.h"

namespace dda {

std::string dc_text(const BlockDrawing& drawing);

}  // namespace dda
