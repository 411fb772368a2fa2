// Catalogue 34: a static stress on edges that absorb waves.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> static_stress_cases();

}  // namespace verify
