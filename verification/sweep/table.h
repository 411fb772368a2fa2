// All jobs of a sweep in one table.
#pragma once

#include <string>
#include <vector>

#include "verification/sweep/sweep_folder.h"

namespace verify {

// One for each job of the spec, in its order.
[[nodiscard]] std::vector<JobFile> read_jobs(const SweepFolder& folder, const SweepSpec& spec);

// CSV: index, status, message, every parameter, every result; what a job has not is empty. A row a job.
[[nodiscard]] std::string to_csv(const SweepSpec& spec, const std::vector<JobFile>& jobs);

// How many jobs ended how, and of how many the prediction agrees with what was measured; a sentence a line.
[[nodiscard]] std::string summary_of(const std::vector<JobFile>& jobs);

}  // namespace verify
