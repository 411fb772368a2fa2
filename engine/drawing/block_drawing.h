// Blocks and the joints between them as other programs are to draw them; lengths in m.
#pragma once

#include <string>
#include <vector>

#include "engine/geometry/polygon.h"

namespace dda {

struct ExportedBlock {
  std::string group;
  std::string name;
  Polygon shape;  // outer ring counter-clockwise, holes clockwise
  std::string material;
};

struct ExportedJoint {
  std::string joint;
  Vec2 from, to;
};

struct BlockDrawing {
  std::vector<ExportedBlock> blocks;
  std::vector<ExportedJoint> joints;
};

}  // namespace dda
