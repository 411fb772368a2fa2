// Catalogue 6 and 7: a row of blocks that passes an impact on, and collisions after which bodies go on together.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

std::vector<Case> collision_cases();

}  // namespace verify
