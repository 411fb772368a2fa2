// Where the projected law can be had in place of springs at closed joints; see check_projected_joints.
#pragma once

#include "engine/model/model.h"

namespace dda {

[[nodiscard]] bool stages_can_have_projected_joints(const Model& model);

// True where the projected law could replace the springs that a joint has in finite kinematics or by its own law.
[[nodiscard]] bool could_be_projected(const Model& model, const JointMaterial& joint);

}  // namespace dda
