#include "engine/solve/iterate.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/contact/contact_sharing.h"
#include "engine/core/parallel.h"
#include "engine/solve/largest_entry.h"

namespace dda {

void Iterate::pose(const StepProblem& posed) {
  problem = &posed;
  constexpr double share =
      1e-13;  // of the largest on the right-hand side, moments as forces at the arm of a block's size
  round_off_of_forces = is_linear() ? 0 : share * largest_of_blocks(problem->rhs, problem->areas);
}

double Iterate::negligible_force(double largest_force) const {
  return std::max(share_of_forces * largest_force, std::max(round_off_of_forces, round_off_of_carrying()));
}

double Iterate::round_off_of_carrying() const {
  constexpr double share = 1e-15;
  const std::span<const int> places = problem->contacts.places;
  const auto carried = [&](std::size_t first, std::size_t last) {
    double largest = 0;
    for (std::size_t i = first; i < last; ++i) {
      const InterfaceElement& element = problem->contacts.elements[static_cast<std::size_t>(places[i])];
      const double way =
          std::max(increment.segment<2>(6 * element.block_a).norm(), increment.segment<2>(6 * element.block_b).norm());
      largest = larger(largest, element.stiffness.maxCoeff() * way);
    }
    return largest;
  };
  return share * parallel_reduce(places.size(), contacts_worth_sharing, larger, carried);
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
