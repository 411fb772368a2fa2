// Where the projected law can be had in place of springs at closed joints; see check_projected_joints.
#pragma once

#include "engine/model/model.h"

namespace dda {

[[nodiscard]] bool stages_can_have_projected_joints(const Model& model);

// Of a joint that has springs where blocks touch, in finite kinematics or by its law.
[[nodiscard]] bool could_be_projected(const Model& model, const JointMaterial& joint);

}  // namespace dda
