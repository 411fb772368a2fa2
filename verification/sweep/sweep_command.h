// `dda-verify sweep`, `job` and `collect`.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <vector>

#include "verification/study/command.h"

namespace verify {

struct SweepCommand {
  std::filesystem::path spec;
  std::filesystem::path folder;
  int jobs = 0;           // at once; 0: as many as there are cores
  bool resume = false;    // go on in a folder that has jobs, and keep those that are done
  bool job_list = false;  // write jobs.txt and slurm.sh, run nothing
};

struct JobCommand {
  std::filesystem::path spec;
  std::size_t index = 0;
  std::filesystem::path folder;
};

// All return the exit code of the program: 0, or 1 if a job failed, crashed or is missing, or there are no plots. Bad
// specs and folders are dda::InputError and std::filesystem::filesystem_error before anything is written.

// `program` is what is started for each job.
int sweep(const SweepCommand& command, const std::filesystem::path& program, std::ostream& out, std::ostream& errors);

// Says on `out` how the job ended, which its file has too.
int job(const JobCommand& command, std::ostream& out);

// results.csv and plots/ from the files of the jobs.
int collect(const std::filesystem::path& folder, std::ostream& out, std::ostream& errors);

// The three of them for a command line.
[[nodiscard]] std::vector<StudyCommand> sweep_commands();

}  // namespace verify
