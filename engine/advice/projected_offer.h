// Where the projected law can be had in place of springs at closed joints.
#pragma once

#include "engine/model/model.h"

namespace dda {

// True where the projected law could replace the springs that a joint has in finite kinematics or by its own law.
[[nodiscard]] bool could_be_projected(const Model& model, const JointMaterial& joint);

}  // namespace dda
