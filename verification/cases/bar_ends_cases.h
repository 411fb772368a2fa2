// Catalogue 34: what comes back from the end of a bar - fixed, free, or on a dashpot.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> bar_ends_cases();

}  // namespace verify
