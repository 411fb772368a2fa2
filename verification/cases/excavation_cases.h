#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

// 28, 31, 41: rock that is removed in a run. A circle under far stresses, in balance after it; tractions that stay; a
// circle removed at once.
std::vector<Case> excavation_cases();

}  // namespace verify
