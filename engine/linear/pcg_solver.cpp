#include "engine/linear/pcg_solver.h"

#include "engine/linear/block_vectors.h"

namespace dda {

void PcgSolver::do_analyze(const BlockMatrix& matrix) {
  factor_.analyze(matrix, options_.fill_level);
  iteration_.resize(matrix.unknowns());
  residual_.resize(matrix.unknowns());
  preconditioned_.resize(matrix.unknowns());
}

Status PcgSolver::do_factorize(const BlockMatrix& matrix) {
  matrix_ = &matrix;
  return factor_.factorize(matrix) ? Status::ok : Status::singular;
}

Status PcgSolver::do_factorize_part(const BlockMatrix& matrix, const BlockPart& part) {
  return factor_.factorize(matrix, part) ? Status::ok : Status::singular;
}

Status PcgSolver::do_solve(const Eigen::VectorXd& rhs, Eigen::VectorXd& x) {
  const auto multiply = [this](const Eigen::VectorXd& v, Eigen::VectorXd& w) { matrix_->multiply(v, w); };
  const auto precondition = [this](const Eigen::VectorXd& r, Eigen::VectorXd& z) { return factor_.apply(r, z); };
  const KrylovResult result =
      iteration_.solve(multiply, precondition, rhs, options_.relative_residual, options_.max_iterations, x);
  count_iterations(result.iterations);
  return result.status == Status::ok ? check(rhs, x) : result.status;
}

// The residual that the iteration carries along parts from the true one where the condition of the matrix nears the
// precision of the numbers.
Status PcgSolver::check(const Eigen::VectorXd& rhs, const Eigen::VectorXd& x) {
  matrix_->multiply(x, residual_);
  in_stretches(rhs.size(), [&](const Stretch& here) { here.of(residual_) = here.of(rhs) - here.of(residual_); });
  const double norm = factor_.apply(residual_, preconditioned_);
  const double limit = options_.true_residual * options_.true_residual * factor_.apply(rhs, preconditioned_);
  return norm <= limit ? Status::ok : Status::not_converged;
}

double PcgSolver::do_precondition(const Eigen::VectorXd& r, Eigen::VectorXd& z) { return factor_.apply(r, z); }

}  // namespace dda
