// One cell of the chart: a run, as `dda run` would take and judge it, beside the answer that is known.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "verification/stability/answers.h"
#include "verification/stability/setting.h"

namespace verify {

enum class Outcome {
  correct,  // went through, and the answer is right
  warned,   // went through, the answer is off, and the run has a warning or a remark
  stopped,  // ended early or with a failed balance, and says why
  refused,  // bad input, says which
  silent,   // anything else: wrong, and nothing was said
};
inline constexpr std::array all_outcomes{Outcome::correct, Outcome::warned, Outcome::stopped, Outcome::refused,
                                         Outcome::silent};
[[nodiscard]] std::string name_of(Outcome outcome);

struct Cell {
  Setting setting;
  Outcome outcome = Outcome::silent;
  std::vector<Check> checks;      // of runs that went through
  std::string message;            // why it stopped or was refused
  std::vector<std::string> said;  // warnings and remarks
  double cpu_s = 0;
  std::string scene;  // file of its scene, in the folder of the chart; empty where none was kept
};

// `scene` is scene_of(setting), or one that is wrong on purpose.
[[nodiscard]] Cell run_cell(const Setting& setting, const nlohmann::ordered_json& scene);

}  // namespace verify
