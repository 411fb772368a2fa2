// A scheme of the study as the engine's settings.
#pragma once

#include "engine/model/model.h"
#include "verification/harness/recorded_run.h"
#include "verification/precision/job.h"

namespace verify {

// Bonded, as the law of that name; shear springs of the classical law 0.4 of the normal ones.
[[nodiscard]] dda::JointMaterial joint_of(const PrecisionScheme& scheme);

// Small motion; dt and duration are not set.
[[nodiscard]] dda::Stage stage_of(const PrecisionScheme& scheme);

struct HistoryErrors {
  double l2 = 0;
  double reading = 0;
};
[[nodiscard]] PrecisionResult result_of(const RecordedRun& run, const dda::Model& model, const HistoryErrors& errors);

}  // namespace verify
