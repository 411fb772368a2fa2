// Catalogue 5: elastic bounce.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> bounce_cases();

}  // namespace verify
