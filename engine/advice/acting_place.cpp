#include "engine/advice/acting_place.h"

#include <algorithm>
#include <limits>

namespace dda {

Vec2 traction_at_start(const Model& model, const EdgeLoad& load) {
  const Block& block = model.blocks[static_cast<std::size_t>(load.block)];
  const Vec3& stress = block.initial_stress;
  const Vec2 edge = (load.to - load.from).normalized();
  Vec2 normal(edge.y(), -edge.x());
  if (normal.dot(block.moments.centroid - load.from) > 0) normal = -normal;
  return {stress[0] * normal.x() + stress[2] * normal.y(), stress[2] * normal.x() + stress[1] * normal.y()};
}

double distance(const Model& model, const ActingPlace& place, const Vec2& point) {
  if (!place.all_of_it) return distance(place.face, point);
  const Ring& ring = model.blocks[static_cast<std::size_t>(place.block)].shape.outer;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i)
    nearest = std::min(nearest, distance(Segment{ring[i], ring[(i + 1) % ring.size()]}, point));
  return nearest;
}

}  // namespace dda
