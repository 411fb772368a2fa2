// Catalogue 24-26: uniaxial compression, stiffness of a stack, a column under its own weight.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> statics_cases();

}  // namespace verify
