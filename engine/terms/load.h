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

}  // namespace dda
