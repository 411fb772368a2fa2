// Point and edge loads as forces on the six unknowns of a block; points relative to its centroid, m.
#pragma once

#include "engine/core/types.h"

namespace dda {

// force: N per m of thickness.
inline Vec6 point_load(const Vec2& offset, const Vec2& force) { return displacement_rows(offset).transpose() * force; }

// Uniform traction (Pa) on a straight edge: the displacement is linear along it, so the middle is exact.
inline Vec6 edge_load(const Vec2& from, const Vec2& to, const Vec2& traction) {
  return point_load((from + to) / 2, (to - from).norm() * traction);
}

// Turns with an edge drawn from end to end as `drawn`, which is `now` now: what a traction has along and across the
// edge it keeps along and across it.
inline Vec2 turned_with_edge(const Vec2& drawn, const Vec2& now, const Vec2& traction) {
  const double size = drawn.norm() * now.norm();
  const double cosine = drawn.dot(now) / size;
  const double sine = (drawn.x() * now.y() - drawn.y() * now.x()) / size;
  return {cosine * traction.x() - sine * traction.y(), sine * traction.x() + cosine * traction.y()};
}

// One that goes in a straight line from traction - rise to traction + rise: with x from -1 to 1 along the edge, the
// integral of rise x (middle + half x) is that of a couple, rise times half of the edge times a third of its length.
inline Vec6 edge_load(const Vec2& from, const Vec2& to, const Vec2& traction, const Vec2& rise) {
  Vec6 forces = edge_load(from, to, traction);
  if (rise.isZero(0)) return forces;
  const Vec2 half = (to - from) / 2;
  const Vec2 third = 2 * half.norm() / 3 * rise;
  return forces + point_load(half, third) - point_load(Vec2::Zero(), third);
}

}  // namespace dda
