// Joints that give way while they are closed, so that waves see them: springs, and those of the projected law that are
// given a stiffness (ADR 35). Without one the projected law carries waves as rock does.
#pragma once

#include <algorithm>
#include <vector>

#include "engine/contact/joint_stiffness.h"
#include "engine/model/model.h"

namespace dda {

inline bool gives_way_closed(const JointMaterial& joint, Kinematics kinematics) {
  return is_springs(joint, kinematics) || (joint.law == InterfaceLaw::projected && joint.normal_stiffness > 0);
}

inline bool one_gives_way_closed(const std::vector<JointMaterial>& joints, Kinematics kinematics) {
  return std::ranges::any_of(joints, [&](const JointMaterial& joint) { return gives_way_closed(joint, kinematics); });
}

}  // namespace dda
