// `dda-verify thesis`: what the thesis says, chapter by chapter, and what this engine says to it.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <vector>

#include "verification/study/command.h"

namespace verify {

struct ThesisCommand {
  std::vector<int> chapters;  // 3 to 6; none: all
  std::filesystem::path folder;
  int jobs = 0;        // runs at once; 0: as many as there are cores
  bool quick = false;  // for tests: small readings of 6.1 in seconds, no runs of 5 and 6.2
};

// Writes DIR/thesis.json, DIR/chapter_N.md, and for chapters 5 and 6 DIR/scenes and DIR/runs, which `program`, dda,
// makes. Runs that are done there are not run again. Returns the exit code: 0 whatever the verdicts are, or 1 if a run
// failed, each told on `errors`.
int judge_thesis(const ThesisCommand& command, const std::filesystem::path& program, std::ostream& out,
                 std::ostream& errors);

// Its program is the dda beside the file that runs.
[[nodiscard]] StudyCommand thesis_command();

}  // namespace verify
