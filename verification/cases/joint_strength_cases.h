// Catalogue 23: a block hung by its joint, a joint in direct shear.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

std::vector<Case> joint_strength_cases();

}  // namespace verify
