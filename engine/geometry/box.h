// Axis-aligned boxes.
#pragma once

#include <limits>

#include "engine/geometry/polygon.h"

namespace dda {

// Empty until expanded: an empty box overlaps nothing.
struct Box {
  Vec2 lower = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 upper = Vec2::Constant(-std::numeric_limits<double>::infinity());

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [lower, upper] = self;
    archive(lower, upper);
  }
};

inline bool is_empty(const Box& box) { return box.lower.x() > box.upper.x() || box.lower.y() > box.upper.y(); }

// Touching counts.
inline bool overlap(const Box& a, const Box& b) {
  return a.lower.x() <= b.upper.x() && a.lower.y() <= b.upper.y() && b.lower.x() <= a.upper.x() &&
         b.lower.y() <= a.upper.y();
}

inline Box expanded(const Box& box, const Vec2& point) {
  return {box.lower.cwiseMin(point), box.upper.cwiseMax(point)};
}

// Grown by `margin` (m) on every side.
inline Box expanded(const Box& box, double margin) {
  return {box.lower - Vec2::Constant(margin), box.upper + Vec2::Constant(margin)};
}

Box bounding_box(const Ring& ring);

inline Box bounding_box(const Polygon& polygon) { return bounding_box(polygon.outer); }

}  // namespace dda
