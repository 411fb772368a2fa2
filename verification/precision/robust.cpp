#include "verification/precision/robust.h"

#include <algorithm>

namespace verify {
namespace {

bool is_finer(const PrecisionJob& job, const PrecisionJob& than) {
  constexpr double same = 1 + 1e-9;  // sizes and steps come from divisions
  return job.problem == than.problem && job.scheme == than.scheme && job.size <= than.size * same &&
         job.dt <= than.dt * same && job.dt / job.size <= than.dt / than.size * same;
}

}  // namespace

std::vector<Measured> robust_runs(const std::vector<Measured>& runs, Norm norm, double error) {
  std::vector<Measured> robust;
  for (const Measured& candidate : runs) {
    const bool holds = std::all_of(runs.begin(), runs.end(), [&](const Measured& other) {
      return !is_finer(other.job, candidate.job) || error_of(other, norm) <= error;
    });
    if (holds) robust.push_back(candidate);
  }
  return robust;
}

}  // namespace verify
