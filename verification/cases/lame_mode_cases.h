// Catalogue 30: the Lame mode of a free square.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> lame_mode_cases();

}  // namespace verify
