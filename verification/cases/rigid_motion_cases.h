// Catalogue 1-3: free fall, fall with k01, free spin.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> rigid_motion_cases();

}  // namespace verify
