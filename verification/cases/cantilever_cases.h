// Catalogue 27: a cantilever of bonded blocks, its deflection and its lowest frequency.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> cantilever_cases();

}  // namespace verify
