// All runs as one tidy CSV.
#pragma once

#include <string>
#include <vector>

#include "verification/precision/front.h"
#include "verification/precision/study.h"

namespace verify {

enum class Norm { l2, reading };  // PrecisionResult::error and ::reading

enum class Cost {
  cpu,     // s
  passes,  // over a cell: the same on every machine
};

[[nodiscard]] double error_of(const Measured& measured, Norm norm);
[[nodiscard]] double cost_of(const Measured& measured, Cost cost);

// Runs of the problem that came out, in their order; one for each element of points_of.
[[nodiscard]] std::vector<Measured> runs_of(const std::vector<Measured>& all, Problem problem);
[[nodiscard]] std::vector<Measured> runs_of(const std::vector<Measured>& all, Problem problem,
                                            const PrecisionScheme& scheme);
[[nodiscard]] std::vector<Measured> engine_runs(const std::vector<Measured>& all, Problem problem);
[[nodiscard]] std::vector<CostAndError> points_of(const std::vector<Measured>& runs, Cost cost, Norm norm = Norm::l2);

// A row a job: problem, scheme, sizes, counts, error, CPU time, and whether it is on the front of all schemes of the
// engine for its problem, by CPU time and by passes.
[[nodiscard]] std::string to_csv(const std::vector<Measured>& all);

}  // namespace verify
