// How far a scene reaches.
#pragma once

#include "engine/geometry/box.h"
#include "engine/model/model.h"

namespace dda {

// The box around all blocks as drawn.
inline Box bounding_box(const Model& model) {
  Box box;
  for (const Block& block : model.blocks) {
    const Box own = bounding_box(block.shape);
    box = expanded(expanded(box, own.lower), own.upper);
  }
  return box;
}

// m, the largest distance between two corners of blocks as drawn: the same whichever way the scene is turned.
double diameter(const Model& model);

// From where local places of the blocks count: the middle of that box, rounded to a power of two that is four to eight
// times their `diameter` (m). So a scene has as many digits wherever it lies, one that lies near the origin of its
// drawing keeps that, and differences of coordinates from here are exact where the scene lies further away.
Vec2 local_origin(const Model& model, double diameter);

// m, the diagonal of that box.
inline double extent(const Model& model) {
  const Box box = bounding_box(model);
  return (box.upper - box.lower).norm();
}

}  // namespace dda
