// Catalogue 17: the chart of a block on an incline: stable, slides, topples, slides and topples.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

[[nodiscard]] std::vector<Case> incline_chart_cases();

}  // namespace verify
