#include "engine/solve/iterate.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "engine/solve/largest_entry.h"

namespace dda {

namespace {

// Springs make forces of the increments that carry blocks along, and these cancel but for their last digits.
double round_off_of_carrying(const StepProblem& problem) {
  constexpr double share = 1e-15;
  double largest = 0;
  for (const int place : problem.contacts.places) {
    const InterfaceElement& element = problem.contacts.elements[static_cast<std::size_t>(place)];
    const double way = problem.guess.segment<2>(6 * element.block_a).norm();
    largest = std::max(largest, element.stiffness.maxCoeff() * way);
  }
  return share * largest;
}

}  // namespace

void Iterate::pose(const StepProblem& posed) {
  problem = &posed;
  constexpr double share =
      1e-13;  // of the largest on the right-hand side, moments as forces at the arm of a block's size
  round_off_of_forces = is_linear() ? 0 : share * largest_of_blocks(problem->rhs, problem->areas);
  if (problem->begins_at_guess) round_off_of_forces = std::max(round_off_of_forces, round_off_of_carrying(*problem));
}

Status Iterate::bring_matrix_up_to_date(bool& changed) {
  const bool bolts_changed = bolts.take_up_rows();
  const std::int64_t changes = contacts.take_up_rows();
  costs.counters.contact_state_changes += changes;
  changed = bolts_changed || changes > 0;
  const bool serves = matrix.is_current() && !changed && !matrix.factor_is_of_part();
  return serves ? Status::ok : refactor();
}

Status Iterate::refactor() {
  matrix.assemble(problem->held, [this](BlockMatrix& values) {
    values.set_values(problem->base);
    contacts.add_stiffness(problem->factor, values);
    bolts.add_stiffness(problem->factor, values);
  });
  return matrix.factorize();
}

void Iterate::add_constant_forces(Eigen::VectorXd& rhs) const {
  contacts.add_rhs(problem->factor, rhs);
  bolts.add_rhs(problem->factor, rhs);
}

}  // namespace dda
