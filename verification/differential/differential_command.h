// `dda-verify differential`.
#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>

#include "verification/study/command.h"

namespace verify {

struct DifferentialCommand {
  std::uint64_t seed = 1;
  int count = 1000;
  std::filesystem::path folder;  // for scenes that differ; empty: none are kept
  bool verbose = false;          // tells every scene
  int jobs = 1;                  // scenes at once
};

// Compares the runs of `count` scenes from `seed` on. Exit code: 0, or 1 if the runs of a scene differ.
[[nodiscard]] int compare_scenes(const DifferentialCommand& command, std::ostream& out, std::ostream& errors);

[[nodiscard]] StudyCommand differential_command();

}  // namespace verify
