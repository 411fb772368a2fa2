#include "engine/advice/reach.h"

#include <cmath>
#include <cstddef>

namespace dda {

Reach reach_of(const Block& block, const Vec2& direction) {
  Reach reach;
  for (const Vec2& vertex : block.shape.outer) reach.include(direction.dot(vertex));
  return reach;
}

Reach reach_of(const Model& model, const Vec2& direction) {
  Reach reach;
  for (const Block& block : model.blocks) {
    const Reach of_block = reach_of(block, direction);
    reach.include(of_block.low);
    reach.include(of_block.high);
  }
  return reach;
}

Reach reach_of(const Model& model, const ActingPlace& place, const Vec2& direction) {
  if (place.all_of_it) return reach_of(model.blocks[static_cast<std::size_t>(place.block)], direction);
  Reach reach;
  reach.include(direction.dot(place.face.start));
  reach.include(direction.dot(place.face.end));
  return reach;
}

double length_at(const Ring& ring, const Vec2& direction, double side, double slack) {
  double length = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& from = ring[i];
    const Vec2& to = ring[(i + 1) % ring.size()];
    if (std::abs(direction.dot(from) - side) <= slack && std::abs(direction.dot(to) - side) <= slack)
      length += (to - from).norm();
  }
  return length;
}

}  // namespace dda
