// Catalogue 43: the lining of a round tunnel.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

std::vector<Case> lining_cases();

}  // namespace verify
