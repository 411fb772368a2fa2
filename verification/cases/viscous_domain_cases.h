// Catalogue 35 in the time domain: plane pulses and a point source in blocks between viscous edges.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> viscous_domain_cases();

}  // namespace verify
