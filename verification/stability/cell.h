// One cell of the chart: a run, as `dda run` would take and judge it, beside the answer that is known.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "verification/stability/answers.h"
#include "verification/stability/setting.h"
#include "verification/study/judged_run.h"

namespace verify {

// "correct" is RunOutcome::right; cells are not timed out, so none is late.
[[nodiscard]] const OutcomeNames& cell_outcomes();
[[nodiscard]] inline const std::string& name_of(RunOutcome outcome) { return name_of(outcome, cell_outcomes()); }

struct Cell : JudgedRun {
  Setting setting;
  std::string scene;  // file of its scene, in the folder of the chart; empty where none was kept
};

// `scene` is scene_of(setting), or one that is wrong on purpose.
[[nodiscard]] Cell run_cell(const Setting& setting, const nlohmann::ordered_json& scene);

}  // namespace verify
