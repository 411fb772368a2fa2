#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

// 29, 40, 41: a pressurised cavity, held and in pulses; a cavity cut suddenly into rock under stress.
std::vector<Case> blast_cases();

}  // namespace verify
