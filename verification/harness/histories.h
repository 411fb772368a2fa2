// Comparing sampled histories, and largest errors.
#pragma once

#include <vector>

namespace verify {

// The larger of `largest` and |error|; what is not a number stays so, where std::max would drop it.
void keep_largest(double& largest, double error);

// max |history - exact| over max |exact|, not a number if a sample is not. Throws std::invalid_argument if their
// lengths differ.
[[nodiscard]] double largest_difference(const std::vector<double>& history, const std::vector<double>& exact);

}  // namespace verify
