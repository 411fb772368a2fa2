// Dry joints under the projected law: waves, stress, columns that open, sliding.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> projected_joint_cases();

}  // namespace verify
