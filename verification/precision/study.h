// Runs the jobs of the study, again and again in turn, and keeps what each run cost.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "verification/precision/job.h"

namespace verify {

// All runs of one job: they give the same error, and the least CPU time counts.
struct Measured {
  PrecisionJob job;
  PrecisionResult result;
  int runs = 0;
  std::string failure;  // why it has no result; empty if it has one
};

struct StudyOptions {
  int rounds = 3;                    // runs of every job, in turn; what takes more than half a second runs once
  bool resume = false;               // go on in a folder that has runs, and keep them
  std::ostream* progress = nullptr;  // a terminal, or none
};

// Runs what FOLDER/runs.jsonl, a line a run, has not yet; a line that is not whole (the program was stopped) does not
// count. In the order of `jobs`. dda::InputError for a folder that has runs, unless they are to be kept.
[[nodiscard]] std::vector<Measured> run_study(const std::vector<PrecisionJob>& jobs,
                                              const std::filesystem::path& folder, const StudyOptions& options);

}  // namespace verify
