// Catalogue 10 and 11: a block on an incline that shakes, a block on a level base that moves to and fro.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

std::vector<Case> shaken_block_cases();

}  // namespace verify
