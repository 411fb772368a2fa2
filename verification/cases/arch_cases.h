// Catalogue 21: a semicircular arch of voussoirs, how thin it may be.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> arch_cases();

}  // namespace verify
