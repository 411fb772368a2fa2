#include "engine/solve/step_matrix.h"

#include <utility>

#include "engine/contact/contact_set.h"
#include "engine/linear/block_vectors.h"

namespace dda {

void add_contact(double factor, const InterfaceElement& element, const ContactRows& rows, bool in_a, bool in_b,
                 BlockMatrix& matrix) {
  if (rows.active.isZero(0) && rows.coupling == 0) return;  // open, or nothing to amend
  const InterfaceMatrices k = stiffness_of(element, rows.active, rows.coupling);
  if (in_a) matrix.diagonal(element.block_a) += factor * k.aa;
  if (in_b) matrix.diagonal(element.block_b) += factor * k.bb;
  if (in_a && in_b) matrix.add_coupling(element.block_b, element.block_a, factor * k.ba);
}

void StepMatrix::begin(BlockMatrix pattern, SolverKind kind, double chi, MatrixUse use) {
  end();
  solver_ = make_solver(kind, chi, use);
  set_pattern(std::move(pattern));
}

void StepMatrix::set_pattern(BlockMatrix pattern) {
  matrix_ = std::move(pattern);
  solver_->analyze(*matrix_);
  ++costs_.counters.analyses;
  is_current_ = false;
}

void StepMatrix::end() {
  costs_.counters.solver_iterations += iterations();
  solver_.reset();
  matrix_.reset();
  is_current_ = false;
}

Status StepMatrix::factorize() {
  const PhaseScope scope(Phase::factorization);
  amendments_ = 0;
  factor_is_of_part_ = false;
  const Status status = solver_->factorize(*matrix_);
  ++costs_.counters.factorizations;
  is_current_ = status == Status::ok;
  if (status != Status::ok) failure_ = Failure::singular_matrix;
  if (is_current_ && !solver_->needs_matrix()) matrix_->forget_values();
  return status;
}

Status StepMatrix::factorize(const BlockPart& part) {
  const PhaseScope scope(Phase::factorization);
  ++costs_.counters.factorizations;
  factor_is_of_part_ = true;
  is_amended_ = true;  // the next step starts with matrix and factor of the whole
  return solver_->factorize(*matrix_, part);
}

void StepMatrix::amend(double factor, const InterfaceElement& element, const ContactRows& rows,
                       const HeldUnknowns& held) {
  add_contact(factor, element, rows, !held.holds(element.block_a), !held.holds(element.block_b), *matrix_);
  ++amendments_;
  is_amended_ = true;
}

Status StepMatrix::solve(const HeldUnknowns& held, Eigen::VectorXd& rhs, Eigen::VectorXd& x) {
  const PhaseScope scope(Phase::solution);
  ++costs_.counters.solves;
  couplings_.move_to_right(held, rhs);
  held.put(x);
  const Status status = solver_->solve(rhs, x);
  held.put(x);
  if (status != Status::ok) {
    failure_ = Failure::linear_solver;
    return status;
  }
  // 0 times anything not finite is NaN, and so is a sum with a NaN: allFinite(), vectorized.
  if (sum_of_stretches(x.size(), [&](const VectorStretch& here) { return (0 * here.of(x)).sum(); }) == 0)
    return Status::ok;
  failure_ = Failure::not_finite;
  return Status::not_finite;
}

}  // namespace dda
