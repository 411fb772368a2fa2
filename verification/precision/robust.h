// Runs whose error does not rest on errors that cancel.
#pragma once

#include <vector>

#include "verification/precision/table.h"

namespace verify {

// Those of `runs` that are within `error` together with every run of their problem and scheme that is finer: blocks,
// time step and the ratio of both no larger. Where the errors of blocks and time steps cancel at one pair of sizes
// alone, finer runs are worse.
[[nodiscard]] std::vector<Measured> robust_runs(const std::vector<Measured>& runs, Norm norm, double error);

}  // namespace verify
