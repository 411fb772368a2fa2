// `dda-verify rocks`.
#pragma once

#include <cstdint>
#include <filesystem>
#include <iosfwd>

#include "verification/rocks/random_rock.h"
#include "verification/study/command.h"

namespace verify {

struct RocksCommand {
  std::filesystem::path folder;
  std::uint64_t seed = 1;
  int count = 500;
  double seconds = 60;  // of CPU time, the most that a rock is given
  RockFamily family;
  int jobs = 1;  // rocks at once
};

// Writes rocks.json, rocks.md and images/ into the folder, and the scene of every rock that is not right into scenes/.
// Exit code: 0, or 1 if a rock is wrong.
[[nodiscard]] int run_rocks(const RocksCommand& command, std::ostream& out, std::ostream& errors);

[[nodiscard]] StudyCommand rocks_command();

}  // namespace verify
