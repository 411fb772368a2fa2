// Catalogue 42: the speed of plane waves in block meshes against their direction.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> direction_cases();

}  // namespace verify
