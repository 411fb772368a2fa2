// Whether a run follows the geometry of its blocks, and their contacts.
#pragma once

#include <algorithm>

#include "engine/model/model.h"

namespace dda {

// In some stage.
inline bool has_finite_kinematics(const Model& model) {
  return std::ranges::any_of(model.stages, [](const Stage& each) { return each.kinematics == Kinematics::finite; });
}

// Blocks that move can come to touch, whether they do at the start or not, unless all joints are bonded.
inline bool contacts_move(const Model& model) {
  const bool can_touch = model.blocks.size() > 1 && !std::ranges::all_of(model.joints, &JointMaterial::bonded);
  return can_touch && has_finite_kinematics(model);
}

}  // namespace dda
