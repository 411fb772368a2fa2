// Catalogue 33, 36-38: S waves, and waves on joints.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> joint_wave_cases();

}  // namespace verify
