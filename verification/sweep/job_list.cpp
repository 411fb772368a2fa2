#include "verification/sweep/job_list.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "engine/core/error.h"
#include "engine/record/atomic_file.h"

namespace verify {
namespace {

std::string slurm_script(const std::string& folder, std::size_t jobs) {
  return fmt::format(R"(#!/bin/sh
#SBATCH --job-name=dda-sweep
#SBATCH --array=1-{}
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --time=01:00:00
# Task number N runs line N of the list. A site may allow fewer tasks in an array (scontrol show config: MaxArraySize).
set -eu
line=$(sed -n "${{SLURM_ARRAY_TASK_ID}}p" {})
eval "$line"
)",
                     jobs, folder);
}

}  // namespace

Command job_command(const std::filesystem::path& program, const SweepFolder& folder, std::size_t index) {
  const std::filesystem::path place = std::filesystem::absolute(folder.path()).lexically_normal();
  return {program.string(),      "job",   SweepFolder(place).spec_file().string(),
          std::to_string(index), "--out", place.string()};
}

std::string shell_word(const std::string& word) {
  constexpr auto harmless = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:=+,@%";
  if (!word.empty() && word.find_first_not_of(harmless) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) {
    quoted += c;
    if (c == '\'') quoted += "\\''";  // the quotation ends, an escaped quote, another begins
  }
  quoted += '\'';
  return quoted;
}

void write_job_list(const std::filesystem::path& program, const SweepFolder& folder,
                    const std::vector<std::size_t>& indices) {
  std::string lines;
  for (const std::size_t index : indices) {
    std::vector<std::string> words = job_command(program, folder, index);
    std::transform(words.begin(), words.end(), words.begin(), shell_word);
    const std::string line = fmt::format("{}", fmt::join(words, " "));
    if (line.find_first_of("\n\r") != std::string::npos)
      throw dda::InputError("", "--out", shell_word(folder.path().string()) + ", with a line break in its whole path",
                            "a path without, as a job list has a line for each job");
    lines += line + '\n';
  }
  const std::filesystem::path list = std::filesystem::absolute(folder.path() / job_list_name).lexically_normal();
  dda::write_file(list, lines);
  dda::write_file(folder.path() / slurm_name, slurm_script(shell_word(list.string()), indices.size()));
}

}  // namespace verify
