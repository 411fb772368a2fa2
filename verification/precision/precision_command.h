// `dda-verify work-precision`.
#pragma once

#include <filesystem>
#include <iosfwd>

#include "verification/study/command.h"

namespace verify {

struct PrecisionCommand {
  std::filesystem::path folder;
  int rounds = 3;
  bool resume = false;
};

// Writes work_precision.csv, work_precision.md and plots/ into the folder. Exit code: 0, or 1 if a run failed or there
// is no gnuplot.
[[nodiscard]] int work_precision(const PrecisionCommand& command, std::ostream& out, std::ostream& errors);

[[nodiscard]] StudyCommand precision_command();

}  // namespace verify
