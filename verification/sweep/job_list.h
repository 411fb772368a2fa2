// The jobs of a sweep as shell commands for other engines: GNU parallel, Slurm.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/study/process_pool.h"
#include "verification/sweep/sweep_folder.h"

namespace verify {

// `PROGRAM job SPEC INDEX --out DIR` with absolute paths.
[[nodiscard]] Command job_command(const std::filesystem::path& program, const SweepFolder& folder, std::size_t index);

// A word as a POSIX shell reads it back.
[[nodiscard]] std::string shell_word(const std::string& word);

inline constexpr auto job_list_name = "jobs.txt";
inline constexpr auto slurm_name = "slurm.sh";

// Writes jobs.txt, a command a line, and slurm.sh, a job array with one task a line.
void write_job_list(const std::filesystem::path& program, const SweepFolder& folder,
                    const std::vector<std::size_t>& indices);

}  // namespace verify
