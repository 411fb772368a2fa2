// `dda-verify stability`.
#pragma once

#include <filesystem>
#include <iosfwd>

#include "verification/study/command.h"

namespace verify {

struct StabilityCommand {
  std::filesystem::path folder;
  bool quick = false;
  int jobs = 1;  // cells at once
};

// Writes stability.json, stability.md and images/ into the folder, and the scene of every cell that is not correct into
// scenes/. Exit code: 0, or 1 if a cell is silently wrong.
[[nodiscard]] int chart_stability(const StabilityCommand& command, std::ostream& out, std::ostream& errors);

[[nodiscard]] StudyCommand stability_command();

}  // namespace verify
