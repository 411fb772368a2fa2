// Chapter 3, the P wave in a bar: its statements judged by the rows of the calibration study.
#pragma once

#include "verification/chapters/statement.h"
#include "verification/thesis/calibration.h"

namespace verify {

// The rows that the statements need: four schemes at both time steps and all block lengths, each run once. About ten
// seconds.
[[nodiscard]] Calibration chapter_3_rows();

[[nodiscard]] Chapter chapter_3(const Calibration& calibration);

}  // namespace verify
