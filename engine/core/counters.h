// What a run did, in counts that do not depend on the machine.
#pragma once

#include <cstdint>

namespace dda {

struct Counters {
  std::int64_t steps = 0;
  std::int64_t matrix_rebuilds = 0;        // times the values of the system matrix were assembled from all terms
  std::int64_t analyses = 0;               // symbolic factorizations
  std::int64_t factorizations = 0;         // numeric factorizations
  std::int64_t solves = 0;                 // linear systems solved
  std::int64_t solver_iterations = 0;      // iterations of the iterative solver, summed over solves
  std::int64_t open_close_iterations = 0;  // passes of the open-close iteration, at least one a step with contacts
  std::int64_t contact_searches = 0;
  std::int64_t contact_state_changes = 0;
};

}  // namespace dda
