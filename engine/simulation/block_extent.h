// How far and how wide blocks are at least and at most, as drawn.
#pragma once

#include <algorithm>

#include "engine/model/model.h"

namespace dda {

// The farthest vertex from the centroid, m.
inline double radius_of(const Block& block) {
  double radius = 0;
  for (const Vec2& vertex : block.shape.outer) radius = std::max(radius, (vertex - block.moments.centroid).norm());
  return radius;
}

// Area over diameter, m: at most the least width. `radius`: radius_of the block.
inline double thickness_of(const Block& block, double radius) { return block.moments.area / (2 * radius); }

}  // namespace dda
