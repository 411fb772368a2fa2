// Catalogue 9 and 12: a block on an incline, a block that slides to rest.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

std::vector<Case> sliding_cases();

}  // namespace verify
