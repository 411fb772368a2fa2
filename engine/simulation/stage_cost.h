// What a stage will cost, counted where it can be and estimated where not.
#pragma once

#include <cstdint>
#include <optional>

#include "engine/contact/contact_set.h"
#include "engine/linear/block_matrix.h"
#include "engine/linear/cholesky_solver.h"
#include "engine/simulation/step_plan.h"

namespace dda {

// Facts of a scene that costs follow from.
struct SceneSize {
  std::int64_t blocks = 0;
  std::int64_t interfaces = 0;
  std::int64_t coupled_pairs = 0;
  CholeskySolver::FactorFacts factor;
};

SceneSize size_of(const ContactSet& contacts, const BlockMatrix& matrix);

// CPU time, s, of a stage whose contacts slide and open in every step: how many passes that takes no one knows before.
struct SlidingCost {
  double least = 0, most = 0;
};

struct StageCost {
  std::int64_t steps = 0;
  std::int64_t factorizations = 0;
  bool at_least = false;        // contacts may change: more factorizations and passes than these
  std::int64_t iterations = 0;  // of PCG, in all; not told where contacts may change
  double seconds = 0;           // CPU time of the steps, of contacts at rest, rough: see README.md
  std::optional<SlidingCost> sliding;
};

StageCost cost_of(const SceneSize& size, const StepPlan& plan, std::int64_t steps);

}  // namespace dda
