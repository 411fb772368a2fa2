// Catalogue 8: energy audit.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> energy_cases();

}  // namespace verify
