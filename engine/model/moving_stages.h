// Whether a run follows the geometry of its blocks.
#pragma once

#include <algorithm>

#include "engine/model/model.h"

namespace dda {

// In some stage.
inline bool has_finite_kinematics(const Model& model) {
  return std::ranges::any_of(model.stages, [](const Stage& each) { return each.kinematics == Kinematics::finite; });
}

}  // namespace dda
