// Catalogue 39: the first frequency of a soil column.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> soil_column_cases();

}  // namespace verify
