// The engine against the closed form of the discrete problem, on bars so long that no end reflection enters.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/model/model.h"
#include "verification/thesis/reference.h"

namespace verify {

struct OracleResult {
  std::string law;  // of the interfaces
  std::string integrator;
  double dt = 0;            // s
  double block_length = 0;  // m
  double max_rel_diff = 0;  // of sigma_x, in units of its peak
};

// Every interface law with every integrator and every block length of the tables; bonded joints, small motion. A bar of
// twice the length keeps the reflection away until long after the run's end. `done` is called after each run.
[[nodiscard]] std::vector<OracleResult> oracle_study(const ThesisReference& reference,
                                                     const std::vector<double>& time_steps, double duration,
                                                     const std::function<void()>& done);

[[nodiscard]] std::size_t oracle_runs(const ThesisReference& reference, std::size_t time_steps);

}  // namespace verify
