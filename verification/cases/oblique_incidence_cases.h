// Catalogue 35: plane waves that meet a viscous edge at an angle.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> oblique_incidence_cases();

}  // namespace verify
