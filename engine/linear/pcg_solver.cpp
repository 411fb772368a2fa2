#include "dda/linear/pcg_solver.h"

#include <cmath>

#include "dda/linear/small_cholesky.h"

namespace dda {
namespace {

// The inverse of a symmetric positive definite block; false where it is not. W^T W is symmetric to the last bit, which
// the iteration needs.
bool invert(const Mat6& block, Mat6& inverse) {
  Mat6 lower;
  if (!factor_block(block, lower)) return false;
  const Mat6 lower_inverse = inverse_of_lower(lower);
  inverse = lower_inverse.transpose().lazyProduct(lower_inverse);
  return true;
}

}  // namespace

void PcgSolver::do_analyze(const BlockMatrix& matrix) {
  inverse_blocks_.resize(static_cast<std::size_t>(matrix.size()));
  for (Eigen::VectorXd* vector : {&residual_, &preconditioned_, &direction_, &image_}) {
    vector->resize(matrix.unknowns());
  }
}

Status PcgSolver::do_factorize(const BlockMatrix& matrix) {
  matrix_ = &matrix;
  for (int i = 0; i < matrix.size(); ++i) {
    if (!invert(matrix.diagonal(i), inverse_blocks_[static_cast<std::size_t>(i)])) return Status::singular;
  }
  return Status::ok;
}

Status PcgSolver::do_solve(const Eigen::VectorXd& rhs, Eigen::VectorXd& x) {
  const double rhs_norm = precondition(rhs);
  if (!std::isfinite(rhs_norm)) return Status::not_finite;
  if (rhs_norm == 0) {
    x.setZero();
    return Status::ok;
  }
  matrix_->multiply(x, image_);
  residual_ = rhs - image_;
  const double residual_norm = precondition(residual_);
  direction_ = preconditioned_;
  return iterate(options_.relative_residual * options_.relative_residual * rhs_norm, residual_norm, x);
}

// Hestenes & Stiefel (1952). `target` and `residual_norm` are r^T M^-1 r, wanted and of the starting guess.
Status PcgSolver::iterate(double target, double residual_norm, Eigen::VectorXd& x) {
  int iteration = 0;
  Status status = Status::ok;
  while (!(residual_norm <= target)) {
    if (!std::isfinite(residual_norm)) status = Status::not_finite;
    if (iteration == options_.max_iterations) status = Status::not_converged;
    if (status != Status::ok) break;
    matrix_->multiply(direction_, image_);
    const double curvature = direction_.dot(image_);
    if (curvature <= 0) {
      status = Status::singular;
      break;
    }
    const double previous = residual_norm;
    residual_norm = advance(previous / curvature, x);
    direction_ = preconditioned_ + (residual_norm / previous) * direction_;
    ++iteration;
  }
  count_iterations(iteration);
  return status;
}

// z = M^-1 r; returns r^T z.
double PcgSolver::precondition(const Eigen::VectorXd& residual) {
  double norm = 0;
  for (Eigen::Index i = 0; i < residual.size(); i += 6) {
    const Vec6 r = residual.segment<6>(i);
    const Vec6 z = inverse_blocks_[static_cast<std::size_t>(i / 6)] * r;
    preconditioned_.segment<6>(i) = z;
    norm += r.dot(z);
  }
  return norm;
}

double PcgSolver::advance(double step, Eigen::VectorXd& x) {
  x += step * direction_;
  residual_ -= step * image_;
  return precondition(residual_);
}

}  // namespace dda
