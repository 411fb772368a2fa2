// Where a body of rock touches another: along a straight stretch of a joint, or in a point.
#pragma once

#include "engine/core/types.h"

namespace dda {

struct JointFace {
  int block = 0;              // of the body
  int neighbour = 0;          // the block on the other side
  int joint = 0;              // index into Model::joints
  Vec2 from, to;              // the same point twice where a corner touches
  Vec2 outward;               // unit normal, out of the body
  double tan_friction = 0;    // -
  double cohesion_force = 0;  // N per m of thickness: cohesion times length

  [[nodiscard]] double length() const { return (to - from).norm(); }  // m
};

// A stretch of a body's outline with nothing beyond it.
struct FreeFace {
  int block = 0;
  Vec2 from, to;
  Vec2 outward;  // unit normal, out of the body

  [[nodiscard]] double length() const { return (to - from).norm(); }  // m
};

}  // namespace dda
