#include "dda/advice/cost.h"

#include <cmath>

namespace dda {
namespace {

// Seconds, on one core of the machine of engine/linear/README.md; README.md of this folder says how far they hold.
constexpr double per_step = 1e-6;
constexpr double per_block = 6e-8;      // products and updates of a step or pass
constexpr double per_interface = 1e-7;  // judging it, and building its part of the matrix
constexpr double cached_nonzeros = 2e6;
constexpr double per_cached_nonzero = 4e-10, per_nonzero = 9e-10;  // of a factor, in a solve
constexpr double per_block_factored = 5e-7;
constexpr double simplicial_rate = 1.2e9, supernodal_rate = 6e9;  // floating-point operations a second
constexpr double per_pcg_block = 6.5e-9;                          // a 6x6 block in an iteration

double solve_seconds(const SceneSize& size, const StepPlan& plan) {
  if (plan.solver == SolverKind::pcg) {
    const double matrix_blocks = static_cast<double>(size.blocks + 2 * size.coupled_pairs);
    return (3 + 67 * std::sqrt(plan.chi)) * matrix_blocks * per_pcg_block;
  }
  const double nonzeros = size.factor.nonzeros;
  return nonzeros * (nonzeros < cached_nonzeros ? per_cached_nonzero : per_nonzero);
}

double factor_seconds(const SceneSize& size) {
  return static_cast<double>(size.blocks) * per_block_factored +
         size.factor.flops / (size.factor.supernodal ? supernodal_rate : simplicial_rate);
}

}  // namespace

SceneSize size_of(const ContactSet& contacts, const BlockMatrix& matrix) {
  CholeskySolver solver;
  solver.analyze(matrix);
  return {matrix.size(), static_cast<std::int64_t>(contacts.interfaces.size()), matrix.couplings(),
          solver.factor_facts()};
}

StageCost cost_of(const SceneSize& size, const StepPlan& plan, std::int64_t steps) {
  StageCost cost;
  cost.steps = steps;
  cost.at_least = plan.contacts_can_change;
  const auto count = static_cast<double>(steps);
  const bool pcg = plan.solver == SolverKind::pcg;
  if (!pcg) cost.factorizations = plan.finite_kinematics ? steps : 1;
  if (pcg) cost.iterations = std::llround(count * (3 + 67 * std::sqrt(plan.chi)));
  double step = per_step + per_block * static_cast<double>(size.blocks) + solve_seconds(size, plan);
  if (!plan.linear) step += per_interface * static_cast<double>(size.interfaces);
  cost.seconds = count * step + static_cast<double>(cost.factorizations) * factor_seconds(size);
  return cost;
}

}  // namespace dda
