// Figures of a block's shape.
#pragma once

#include "engine/geometry/polygon.h"

namespace dda {

struct BlockShape {
  double area = 0;      // m2
  double sharpest = 0;  // rad, the sharpest corner of the block, holes included
  double aspect = 0;    // of the rectangle with the same second moments of area
};

// `polygon` has its outer ring counter-clockwise and its holes clockwise, as blocks have.
BlockShape shape_of(const Polygon& polygon);

}  // namespace dda
