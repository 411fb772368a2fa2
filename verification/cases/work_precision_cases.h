// Catalogue 32: what accuracy costs, in passes over a block, which are the same on every machine.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

std::vector<Case> work_precision_cases();

}  // namespace verify
