// calibration.json: {"rows": [...], ...}, one row for each (scheme, dt, block length).
#pragma once

#include <string>
#include <vector>

#include "verification/thesis/calibration.h"
#include "verification/thesis/promises.h"

namespace verify {

// Numbers that are not finite or do not apply are null.
[[nodiscard]] std::string to_json(const Calibration& calibration, const std::vector<Promise>& promises);

}  // namespace verify
