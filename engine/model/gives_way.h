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

// A dry joint has nothing to break.
inline bool gives_way(const JointMaterial& joint) { return !joint.bonded && !is_dry(joint); }

inline bool something_gives_way(const Model& model) {
  return std::ranges::any_of(model.bolts, [](const Bolt& bolt) { return gives_way(bolt); }) ||
         std::ranges::any_of(model.joints, [](const JointMaterial& joint) { return gives_way(joint); }) ||
         std::ranges::any_of(model.linings, [](const Lining& lining) { return lining.yields(); });
}

}  // namespace dda
