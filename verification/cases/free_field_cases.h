// Catalogue 39: layers shaken from below between sides that follow the free field.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> free_field_cases();

}  // namespace verify
