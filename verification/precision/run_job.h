// Runs a job of the study.
#pragma once

#include "verification/precision/job.h"

namespace verify {

// Throws std::runtime_error if the run fails.
[[nodiscard]] PrecisionResult run_job(const PrecisionJob& job);

}  // namespace verify
