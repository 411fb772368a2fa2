// Rock bolts. The catalogue has no number of its own for them: they stand with the problems they are nearest to.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

std::vector<Case> bolt_cases();

}  // namespace verify
