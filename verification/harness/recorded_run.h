// Runs a model from start to end, keeping every step of its measurements and what the run cost.
#pragma once

#include <vector>

#include "engine/core/counters.h"
#include "engine/linear/solver_choice.h"
#include "engine/model/energy.h"
#include "engine/model/model.h"
#include "engine/simulation/simulation.h"

namespace verify {

struct RecordedRun {
  double dt = 0;                               // s, between samples
  std::vector<std::vector<double>> histories;  // one per measurement, SI; sample i is at t = i dt, the first at rest
  dda::Counters counters;
  dda::EnergyLedger energy;
  dda::SolverKind solver = dda::SolverKind::cholesky;
  double setup_cpu_s = 0;  // contacts, analysis of the matrix
  double cpu_s = 0;        // CPU time of all steps, with reading the measurements after each
};

// `model` is finished (finish_model) and has one stage. Throws std::runtime_error, saying when and why, if a step
// fails.
[[nodiscard]] RecordedRun record_run(const dda::Model& model);

// `steps` steps, or all that are left. Throws std::runtime_error, saying when and why, if a step fails.
void advance(dda::Simulation& simulation, int steps);
void advance_to_end(dda::Simulation& simulation);

// CPU time of this process so far, s: what two runs on a busy machine can be compared by.
[[nodiscard]] double cpu_seconds();

}  // namespace verify
