// Rock that a body meets as soon as it begins to move, and that its faces do not show: a corner that lies on a corner,
// or just beside it.
#pragma once

#include <vector>

#include "engine/geometry/near_shapes.h"
#include "engine/keyblocks/rock_bodies.h"
#include "engine/model/model.h"

namespace dda {

struct Obstacle {
  int block = 0;  // of the rock
  Vec2 at;        // the corner of the body, or of the rock, as it is now
};

class Obstacles {
 public:
  // `is_void` marks blocks that are taken out. Both stay in use.
  Obstacles(const Model& model, const std::vector<bool>& is_void);

  // What a body touches or enters when it has moved a small step (a thousandth of its size) towards `direction`, a unit
  // vector. Edges that it slides along do not count, though rock that is level with them beyond their ends does. Each
  // block once.
  [[nodiscard]] std::vector<Obstacle> in_way_of(const RockBody& body, const Vec2& direction) const;

 private:
  const Model& model_;
  const std::vector<bool>& is_void_;
  ShapeIndex index_;
};

}  // namespace dda
