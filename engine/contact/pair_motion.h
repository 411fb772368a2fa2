// How far the blocks of a pair move against each other in a step: what decides from how far away their contacts must be
// looked for.
#pragma once

#include <Eigen/Core>

#include "engine/core/types.h"
#include "engine/geometry/box.h"

namespace dda {

// Displacement (m) of the point at `arm` (m) from a block's centroid, by the block's six increments: first order, as
// the gaps of a step are.
Vec2 displacement_of(const Vec6& increments, const Vec2& arm);

// A block as far as its motion is concerned: its box and centroid at the start of a step, in local places, and its
// increments.
struct MovingBox {
  Box box;
  Vec2 centroid;
  Vec6 increments;
};

// Displacement (m) of the point of the block that is at `place` (m).
inline Vec2 displacement_at(const MovingBox& block, const Vec2& place) {
  return displacement_of(block.increments, place - block.centroid);
}

// Where that point comes to, m: not to first order, but as blocks are moved.
Vec2 place_after(const MovingBox& block, const Vec2& place);

// The largest displacement (m) of any point of the box. The displacement is affine, so a corner has it.
double largest_displacement(const MovingBox& block);

// The largest relative displacement (m) of points where the boxes, each grown by `distance` (m), have in common; 0
// where they have nothing in common.
double relative_displacement(const MovingBox& a, const MovingBox& b, double distance);

}  // namespace dda
