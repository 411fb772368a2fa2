// Blocks as drawings for other programs.
#pragma once

#include <filesystem>
#include <string>

#include "engine/drawing/block_drawing.h"

namespace dda {

// Whether the name of the file says in which format to write: .dxf, .geojson or .dc.
bool is_block_format(const std::filesystem::path& file);

// The text of the file, in m, on the layers of layer_for(), so that read_drawing() and plan_of() give the same blocks
// again. DXF is that of release 12, which every program reads: blocks are closed polylines, holes too, on layers whose
// names keep letters, digits, "-" and "_"; names in full and materials are extended data. GeoJSON has polygons with
// their holes and lines. The file for dc has the outline of all blocks as lines of joint material 1, joints by their
// names from 1 on in the order of their first lines, and a hole point in each gap between blocks.
std::string block_file(const std::filesystem::path& file, const BlockDrawing& drawing);

// A sentence on names that have no place in the format, and what stands for them; empty where all have one.
std::string names_left_out(const std::filesystem::path& file, const BlockDrawing& drawing);

}  // namespace dda
