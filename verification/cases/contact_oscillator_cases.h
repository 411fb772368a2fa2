// Catalogue 4: two equal blocks joined by springs swing against each other.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> contact_oscillator_cases();

}  // namespace verify
