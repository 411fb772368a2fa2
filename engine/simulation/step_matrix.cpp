// The matrix of a step of Simulation: assembled, brought up to date, factored, and solved with.
#include <algorithm>
#include <cstddef>

#include "engine/simulation/simulation.h"
#include "engine/simulation/system_matrix.h"

namespace dda {
Status Simulation::refactor() {
  assemble_matrix();
  return factorize();
}

void Simulation::assemble_matrix() {
  const PhaseTimer timer(phase_times_.assembly);
  if (plan_.linear) {
    assemble(coefficients_, *linear_, damping_, matrix_);
  } else {
    assemble(coefficients_, terms_, damping_, supports_, contacts_, matrix_rows_, matrix_);
    bolts_.add_stiffness(coefficients_.stiffness, matrix_);
  }
  held_.take_out(matrix_);
  ++counters_.matrix_rebuilds;
  newton_.matrix_amended = false;
}

Status Simulation::factorize() {
  const PhaseTimer timer(phase_times_.factorization);
  newton_.stale_interfaces = 0;
  newton_.is_local = false;
  const Status status = solver_->factorize(matrix_);
  ++counters_.factorizations;
  matrix_is_current_ = status == Status::ok;
  if (status != Status::ok)
    message_ = "the system matrix is not positive definite: a block is not held, or data overflow";
  return status;
}

Status Simulation::solve_for_increment(Eigen::VectorXd& increment) {
  const PhaseTimer timer(phase_times_.solution);
  ++counters_.solves;
  held_.move_to_right(rhs_);
  held_.put(increment);
  const Status status = solver_->solve(rhs_, increment);
  held_.put(increment);
  if (status != Status::ok) {
    message_ = "the linear solver failed";
    return status;
  }
  // 0 times anything not finite is NaN, and so is a sum with a NaN: allFinite(), vectorized.
  if ((0 * increment).sum() == 0) return Status::ok;
  message_ = "a displacement is not finite";
  return Status::not_finite;
}

// The matrix holds the stiffness of `matrix_rows_`; it must be that of the rows active now. Assembled and factored
// where something changed, if `anew`; else interface by interface, and the factor stays behind. (Held blocks that move
// would need what was taken out of the matrix anew.)
Status Simulation::bring_matrix_up_to_date(bool anew, bool& changed) {
  const bool whole = !matrix_is_current_ || matrix_rows_.size() != trial_.size();
  if (matrix_rows_.size() != trial_.size()) matrix_rows_.assign(trial_.size(), Vec4::Constant(-1));
  changed = bolts_.active_rows_changed();
  anew = anew || whole || changed || held_.move();
  if (!anew) {
    for (const std::size_t k : newton_.taken) changed = take_up_active_rows(newton_.live[k].interface, true) || changed;
    return Status::ok;
  }
  for (std::size_t i = 0; i < trial_.size(); ++i) changed = take_up_active_rows(i, false) || changed;
  return whole || changed || newton_.is_local ? refactor() : Status::ok;
}

bool Simulation::take_up_active_rows(std::size_t i, bool amend) {
  if (matrix_rows_[i] == trial_[i].active) return false;
  if (amend) amend_matrix(i);
  matrix_rows_[i] = trial_[i].active;
  ++counters_.contact_state_changes;
  return true;
}

void Simulation::amend_matrix(std::size_t i) {
  const InterfaceElement& element = contacts_.elements[i];
  add_contact(coefficients_.stiffness, element, trial_[i].active - matrix_rows_[i], !held_.holds(element.block_a),
              !held_.holds(element.block_b), matrix_);
  ++newton_.stale_interfaces;
  newton_.matrix_amended = true;
}

}  // namespace dda
