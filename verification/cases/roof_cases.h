// Catalogue 20 and 22: a prism in a roof, a laminated voussoir roof.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> roof_cases();

}  // namespace verify
