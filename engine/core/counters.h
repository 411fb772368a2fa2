// What a run did, in counts that do not depend on the machine.
#pragma once

#include <array>
#include <cstdint>

namespace dda {

struct Counters {
  std::int64_t steps = 0;
  std::int64_t matrix_rebuilds = 0;          // times the values of the system matrix were assembled from all terms
  std::int64_t analyses = 0;                 // symbolic factorizations
  std::int64_t factorizations = 0;           // numeric factorizations, of the whole matrix or a part
  std::int64_t solves = 0;                   // linear systems solved
  std::int64_t solver_iterations = 0;        // iterations of the iterative solver, summed over solves
  std::int64_t open_close_iterations = 0;    // passes of the open-close iteration, at least one a step with contacts
  std::int64_t local_passes = 0;             // of them, those that moved a part of the blocks
  std::int64_t steps_of_given_friction = 0;  // and parts of steps, which took friction from their start (ADR 48)
  std::int64_t contact_searches = 0;
  std::int64_t contact_state_changes = 0;
};

struct CounterField {
  const char* name;  // as in summary.json
  std::int64_t Counters::*value;
};

inline constexpr std::array counter_fields{
    CounterField{"steps", &Counters::steps},
    CounterField{"matrix_rebuilds", &Counters::matrix_rebuilds},
    CounterField{"analyses", &Counters::analyses},
    CounterField{"factorizations", &Counters::factorizations},
    CounterField{"solves", &Counters::solves},
    CounterField{"solver_iterations", &Counters::solver_iterations},
    CounterField{"open_close_iterations", &Counters::open_close_iterations},
    CounterField{"local_passes", &Counters::local_passes},
    CounterField{"steps_of_given_friction", &Counters::steps_of_given_friction},
    CounterField{"contact_searches", &Counters::contact_searches},
    CounterField{"contact_state_changes", &Counters::contact_state_changes},
};
static_assert(sizeof(Counters) == counter_fields.size() * sizeof(std::int64_t), "counter_fields lists every counter");

inline Counters& operator+=(Counters& sum, const Counters& added) {
  for (const CounterField& field : counter_fields) sum.*field.value += added.*field.value;
  return sum;
}

}  // namespace dda
