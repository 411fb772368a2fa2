// Dry brick walls under their weight (catalogue 22; the scenes of the speed comparison).
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

std::vector<Case> wall_cases();

}  // namespace verify
