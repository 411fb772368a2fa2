// Catalogue 27 in plane strain: a cantilever of nearly incompressible rock, in meshes that could lock.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> incompressible_cases();

}  // namespace verify
