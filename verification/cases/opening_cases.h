#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

// 28, 31: a circular opening in a biaxial field; an opening whose removed rock is replaced by its tractions.
std::vector<Case> opening_cases();

}  // namespace verify
