// `dda-verify stability`.
#pragma once

#include <filesystem>
#include <iosfwd>

namespace verify {

struct StabilityCommand {
  std::filesystem::path folder;
  bool quick = false;
};

// Writes stability.json, stability.md and images/ into the folder, and the scene of every cell that is not correct into
// scenes/. Exit code: 0, or 1 if a cell is silently wrong.
[[nodiscard]] int chart_stability(const StabilityCommand& command, std::ostream& out, std::ostream& errors);

}  // namespace verify
