// How far blocks reach along a direction, and what of them lies where they end.
#pragma once

#include <algorithm>
#include <limits>

#include "engine/advice/acting_place.h"
#include "engine/model/model.h"

namespace dda {

// To the left of a direction, as long as it.
inline Vec2 left_of(const Vec2& direction) { return {-direction.y(), direction.x()}; }

struct Reach {
  double low = std::numeric_limits<double>::infinity();    // m
  double high = -std::numeric_limits<double>::infinity();  // m

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] double length() const { return high - low; }
};

// Along a unit vector, of blocks as drawn.
Reach reach_of(const Block& block, const Vec2& direction);
Reach reach_of(const Model& model, const Vec2& direction);
Reach reach_of(const Model& model, const ActingPlace& place, const Vec2& direction);

// m, of an outline that lies where `direction` has come to `side`, but for `slack` (m).
double length_at(const Ring& ring, const Vec2& direction, double side, double slack);

}  // namespace dda
