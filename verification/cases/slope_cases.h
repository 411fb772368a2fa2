// Catalogue 18 and 19: Goodman and Bray's toppling slope, plane failure.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> slope_cases();

}  // namespace verify
