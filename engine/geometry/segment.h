// Straight segments: distances, crossings, common stretches. Lengths in m.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/core/types.h"

namespace dda {

struct Segment {
  Vec2 start;
  Vec2 end;
};

// The third component of a x b; positive when b points left of a.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

inline Vec2 point_at(const Segment& segment, double parameter) {
  return segment.start + parameter * (segment.end - segment.start);
}

// Parameter in [0, 1] of the point of `segment` nearest to `point`; 0 for a segment without length.
inline double closest_parameter(const Segment& segment, const Vec2& point) {
  const Vec2 along = segment.end - segment.start;
  const double squared_length = along.squaredNorm();
  if (squared_length == 0) return 0;
  return std::clamp(along.dot(point - segment.start) / squared_length, 0.0, 1.0);
}

inline Vec2 closest_point(const Segment& segment, const Vec2& point) {
  return point_at(segment, closest_parameter(segment, point));
}

inline double distance(const Segment& segment, const Vec2& point) {
  return (point - closest_point(segment, point)).norm();
}

// The point where the interiors of two segments cross; nothing when they only touch, are parallel or stay apart.
std::optional<Vec2> proper_intersection(const Segment& a, const Segment& b);

// Least distance between two segments; 0 when they cross.
double distance(const Segment& a, const Segment& b);

// The stretch of `a`, in the direction of `a`, along which `b` runs beside it within `tolerance` (m), whichever way `b`
// points; nothing when that is not longer than `tolerance` or the two diverge by more over their common length.
std::optional<std::pair<Vec2, Vec2>> collinear_overlap(const Segment& a, const Segment& b, double tolerance);

}  // namespace dda
