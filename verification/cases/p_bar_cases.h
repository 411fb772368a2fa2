// Catalogue 32: a P wave along a bar, against the wave equation and against the closed form of the discrete chain.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> p_bar_cases();

}  // namespace verify
