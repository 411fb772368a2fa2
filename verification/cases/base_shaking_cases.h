// Catalogue 4 and 11: a base that follows a record, and an elastic oscillator on it.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

std::vector<Case> base_shaking_cases();

}  // namespace verify
