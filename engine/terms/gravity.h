// Weight: acts at the centroid.
#pragma once

#include "engine/core/types.h"

namespace dda {

inline Vec2 weight(double mass, const Vec2& gravity) { return mass * gravity; }

}  // namespace dda
