// The joint along an interface.
#pragma once

#include <cstddef>

#include "engine/contact/interface.h"
#include "engine/model/model.h"

namespace dda {

inline const JointMaterial& joint_of(const Model& model, const Interface& interface) {
  return model.joints[static_cast<std::size_t>(interface.joint)];
}

}  // namespace dda
