// Catalogue 14-16: a block that rocks, its impact, and the floor's acceleration at which it starts to.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> rocking_cases();

}  // namespace verify
