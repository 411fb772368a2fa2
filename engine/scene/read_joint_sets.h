// Joint sets of rock in a scene.
#pragma once

#include <vector>

#include "engine/cutting/joint_sets.h"
#include "engine/model/model.h"
#include "engine/scene/field.h"

namespace dda {

std::vector<JointSet> read_joint_sets(const Field& sets, const Model& model);

}  // namespace dda
