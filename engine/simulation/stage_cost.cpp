#include "engine/simulation/stage_cost.h"

#include <algorithm>
#include <cmath>

#include "engine/linear/solver_choice.h"

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
// A 6x6 block in an iteration, with diagonal blocks and with an incomplete factor for a preconditioner.
constexpr double per_pcg_block = 6.5e-9, per_factored_pcg_block = 2.5e-8;
constexpr double per_explicit_block = 7e-8;  // product, accelerations, update and energies of an explicit step
// Where contacts can change: a step at rest looks at every contact once; a pass of the open-close iteration judges it,
// brings its part of the matrix and of the factor up to date and solves.
constexpr double per_contact_at_rest = 4.5e-8;
constexpr double per_contact_in_pass = 2.7e-7;
constexpr double cached_contacts = 1e4;
constexpr double factored_in_pass = 0.6;  // complete factors a pass, where there is one
constexpr double spread = 3;              // of the number of passes, to either side

double factor_solve_seconds(const SceneSize& size) {
  const double nonzeros = size.factor.nonzeros;
  return nonzeros * (nonzeros < cached_nonzeros ? per_cached_nonzero : per_nonzero);
}

double solve_seconds(const SceneSize& size, const StepPlan& plan) {
  if (is_iterative(plan.solver)) {
    const double matrix_blocks = static_cast<double>(size.blocks + 2 * size.coupled_pairs);
    return expected_iterations(plan.chi.largest) * matrix_blocks *
           (has_incomplete_factor(plan.chi.largest) ? per_factored_pcg_block : per_pcg_block);
  }
  return factor_solve_seconds(size);
}

double factor_seconds(const SceneSize& size) {
  return static_cast<double>(size.blocks) * per_block_factored +
         size.factor.flops / (size.factor.supernodal ? supernodal_rate : simplicial_rate);
}

double rest_step_seconds(const SceneSize& size) {
  return per_step + per_block * static_cast<double>(size.blocks) + factor_solve_seconds(size) +
         per_contact_at_rest * static_cast<double>(size.interfaces);
}

// The passes are those of walls from 28 to 10,000 bricks: 1.5 to 9 a step.
double sliding_step_seconds(const SceneSize& size, const StepPlan& plan) {
  const auto contacts = static_cast<double>(size.interfaces);
  const double passes = 5 * std::pow(static_cast<double>(size.blocks) / 100, 0.12);
  const double uncached = std::pow(std::max(1.0, contacts / cached_contacts), 0.2);
  const double factors = is_iterative(plan.solver) ? 0 : factored_in_pass * factor_seconds(size);
  return passes * (per_step + per_contact_in_pass * contacts * uncached + factors);
}

StageCost changing_cost(const SceneSize& size, const StepPlan& plan, std::int64_t steps) {
  const auto count = static_cast<double>(steps);
  StageCost cost;
  cost.steps = steps;
  cost.at_least = true;
  cost.factorizations = 1;
  cost.seconds = count * rest_step_seconds(size) + factor_seconds(size);
  const double sliding = count * sliding_step_seconds(size, plan);
  cost.sliding = SlidingCost{std::max(cost.seconds, sliding / spread), std::max(cost.seconds, sliding * spread)};
  return cost;
}

// No system: a product and what is done block by block.
StageCost explicit_cost(const SceneSize& size, std::int64_t steps) {
  StageCost cost;
  cost.steps = steps;
  cost.seconds = static_cast<double>(steps) * (per_step + per_explicit_block * static_cast<double>(size.blocks));
  return cost;
}

}  // namespace

SceneSize size_of(const ContactSet& contacts, const BlockMatrix& matrix) {
  CholeskySolver solver;
  solver.analyze(matrix);
  return {matrix.size(), static_cast<std::int64_t>(contacts.interfaces.size()), matrix.couplings(),
          solver.factor_facts()};
}

StageCost cost_of(const SceneSize& size, const StepPlan& plan, std::int64_t steps) {
  if (plan.contacts_can_change) return changing_cost(size, plan, steps);
  if (plan.explicit_steps) return explicit_cost(size, steps);
  StageCost cost;
  cost.steps = steps;
  const auto count = static_cast<double>(steps);
  const bool iterates = is_iterative(plan.solver);
  if (!iterates) cost.factorizations = plan.finite_kinematics ? steps : 1;
  if (iterates) cost.iterations = std::llround(count * expected_iterations(plan.chi.largest));
  double step = per_step + per_block * static_cast<double>(size.blocks) + solve_seconds(size, plan);
  if (!plan.linear) step += per_interface * static_cast<double>(size.interfaces);
  cost.seconds = count * step + static_cast<double>(cost.factorizations) * factor_seconds(size);
  return cost;
}

}  // namespace dda
