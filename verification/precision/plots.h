// Error against cost, a figure for every problem and cost.
#pragma once

#include <filesystem>
#include <vector>

#include "verification/precision/study.h"

namespace verify {

// Writes PROBLEM_COST.dat, .gp and .svg into `folder`: fronts of some schemes, the front of the engine, and all its
// runs as dots. Throws std::runtime_error if gnuplot or a file fails.
void plot_study(const std::vector<Measured>& all, const std::filesystem::path& folder);

}  // namespace verify
