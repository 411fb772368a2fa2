// Catalogue 13: driven stick-slip, by a force and by a spring.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

std::vector<Case> stick_slip_cases();

}  // namespace verify
