// What a wanted error costs with every scheme.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/precision/table.h"

namespace verify {

// Cheapest run of a scheme with at most that error.
[[nodiscard]] std::optional<Measured> cheapest_run(const std::vector<Measured>& runs, Cost cost, Norm norm,
                                                   double error);

// Cost of the thesis' scheme over that of the accurate one, each at its cheapest for that error; none if one of them
// does not reach it.
[[nodiscard]] std::optional<double> gain(const std::vector<Measured>& all, Problem problem, Cost cost, Norm norm,
                                         double error);

// Markdown: a table a problem.
[[nodiscard]] std::string summary_of(const std::vector<Measured>& all);

}  // namespace verify
