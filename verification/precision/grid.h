// The runs of the study.
#pragma once

#include <vector>

#include "verification/precision/job.h"

namespace verify {

// Every scheme, block size and time step of the study, the yardstick's among them; all keys differ.
[[nodiscard]] std::vector<PrecisionJob> study_jobs();

// What PrecisionResult::passes will at least be.
[[nodiscard]] double planned_passes(const PrecisionJob& job);

// All schemes of a problem, the yardstick's last.
[[nodiscard]] std::vector<PrecisionScheme> study_schemes(Problem problem);

}  // namespace verify
