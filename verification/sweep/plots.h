// The figures of a sweep, made by gnuplot.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/sweep/sweep_folder.h"

namespace verify {

// One part of the jobs: those that share all parameters but the axes of a plot.
struct PlotGroup {
  std::string title;  // what distinguishes it from the other groups; empty if nothing does
  std::vector<std::size_t> jobs;
};

[[nodiscard]] std::vector<PlotGroup> groups_of(const SweepSpec& spec, const SweepPlot& plot);

// Writes NAME.dat, NAME.gp and NAME.svg of every figure into `folder`. Throws std::runtime_error if gnuplot or a file
// fails. Jobs without a result are left out.
void plot_sweep(const SweepSpec& spec, const std::vector<JobFile>& jobs, const std::filesystem::path& folder);

}  // namespace verify
