// Blocks as drawings for other programs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/geometry/polygon.h"

namespace dda {

struct ExportedBlock {
  std::string layer;
  std::string name;
  Polygon shape;
};

struct ExportedJoint {
  std::string layer;
  Vec2 from, to;
};

struct BlockDrawing {
  std::vector<ExportedBlock> blocks;
  std::vector<ExportedJoint> joints;
};

// Whether the name of the file says in which format to write: .dxf, .geojson or .dc.
bool is_block_format(const std::filesystem::path& file);

// The text of the file. DXF is that of release 12, which every program reads, in m: blocks are closed polylines, holes
// too, on layers whose names keep letters, digits, "-" and "_". GeoJSON has polygons with their holes and lines, in m.
// The file for dc has the outline of all blocks as lines of joint material 1, and joints by their layers from 1 on in
// the order of their first lines.
std::string block_file(const std::filesystem::path& file, const BlockDrawing& drawing);

}  // namespace dda
