#include "engine/solve/iterate.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "engine/solve/largest_entry.h"

namespace dda {

double Iterate::round_off_of_forces() const {
  constexpr double share =
      1e-13;  // of the largest on the right-hand side, moments as forces at the arm of a block's size
  double largest = 0;
  for (std::size_t block = 0; block < problem->areas.size(); ++block)
    largest = std::max(largest, largest_entry(problem->rhs, block, problem->areas[block]));
  return share * largest;
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
