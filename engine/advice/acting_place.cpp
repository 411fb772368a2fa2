#include "engine/advice/acting_place.h"

#include <algorithm>
#include <limits>

namespace dda {

double distance(const Model& model, const ActingPlace& place, const Vec2& point) {
  if (!place.all_of_it) return distance(place.face, point);
  const Ring& ring = model.blocks[static_cast<std::size_t>(place.block)].shape.outer;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i)
    nearest = std::min(nearest, distance(Segment{ring[i], ring[(i + 1) % ring.size()]}, point));
  return nearest;
}

}  // namespace dda
