#include "engine/cutting/block_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/geometry/segment.h"

namespace dda {
namespace {

// Material lies on the left of every edge.
double sharpest_corner(const Ring& ring) {
  double sharpest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& corner = ring[(i + 1) % ring.size()];
    const Vec2 back = ring[i] - corner;
    const Vec2 on = ring[(i + 2) % ring.size()] - corner;
    const double angle = std::atan2(cross(on, back), on.dot(back));
    sharpest = std::min(sharpest, angle < 0 ? angle + 2 * std::numbers::pi : angle);
  }
  return sharpest;
}

// Extents of a rectangle go with the square roots of its principal second moments.
double aspect_of(const AreaMoments& moments) {
  const double mean = (moments.xx + moments.yy) / 2;
  const double half_difference = std::hypot((moments.xx - moments.yy) / 2, moments.xy);
  return std::sqrt((mean + half_difference) / (mean - half_difference));
}

}  // namespace

BlockShape shape_of(const Polygon& polygon) {
  const AreaMoments moments = area_moments(polygon);
  BlockShape shape{moments.area, sharpest_corner(polygon.outer), aspect_of(moments)};
  for (const Ring& hole : polygon.holes) shape.sharpest = std::min(shape.sharpest, sharpest_corner(hole));
  return shape;
}

}  // namespace dda
