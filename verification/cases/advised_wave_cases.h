// Catalogue 42: what the adviser foretells of plane waves, against runs of them.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

std::vector<Case> advised_wave_cases();

}  // namespace verify
