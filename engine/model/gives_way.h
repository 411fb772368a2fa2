// Whether something in a scene gives way for good: what has yielded or broken on the way to an equilibrium stays so.
#pragma once

#include <algorithm>
#include <limits>

#include "engine/model/model.h"

namespace dda {

inline bool gives_way(const Bolt& bolt) {
  constexpr double never = std::numeric_limits<double>::infinity();
  return std::min({bolt.yield_force, bolt.shear_yield_force, bolt.rupture_elongation}) < never;
}

inline bool something_gives_way(const Model& model) {
  return std::ranges::any_of(model.bolts, gives_way) || std::ranges::any_of(model.joints, can_break) ||
         std::ranges::any_of(model.linings, &Lining::yields);
}

}  // namespace dda
