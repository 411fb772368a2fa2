// Catalogue 34: what a viscous edge sends back of P and S waves at normal incidence, impedance ratios 0 to 10.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> absorbing_end_cases();

}  // namespace verify
