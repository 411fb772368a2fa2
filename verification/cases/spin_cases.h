// Catalogue 3: elastic blocks that spin: what they carry, and that no integrator gives them energy.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> spin_cases();

}  // namespace verify
