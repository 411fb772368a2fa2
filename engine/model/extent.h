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

// m, the diagonal of that box.
inline double extent(const Model& model) {
  const Box box = bounding_box(model);
  return (box.upper - box.lower).norm();
}

}  // namespace dda
