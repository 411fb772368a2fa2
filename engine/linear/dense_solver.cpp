#include "engine/linear/dense_solver.h"

#include <Eigen/Cholesky>

#include "engine/linear/pivot_test.h"

namespace dda {

struct DenseSolver::Factor {
  Eigen::LLT<Eigen::MatrixXd> llt;
};

Eigen::MatrixXd to_dense(const BlockMatrix& matrix) {
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(matrix.unknowns(), matrix.unknowns());
  for (int j = 0; j < matrix.size(); ++j) {
    dense.block<6, 6>(6 * j, 6 * j) = matrix.diagonal(j);
    for (int i = j + 1; i < matrix.size(); ++i) {
      const int slot = matrix.slot(i, j);
      if (slot < 0) continue;
      dense.block<6, 6>(6 * i, 6 * j) = matrix.offdiagonal(slot);
      dense.block<6, 6>(6 * j, 6 * i) = matrix.offdiagonal(slot).transpose();
    }
  }
  return dense;
}

DenseSolver::DenseSolver() = default;
DenseSolver::~DenseSolver() = default;

void DenseSolver::do_analyze(const BlockMatrix&) { factor_ = std::make_unique<Factor>(); }

Status DenseSolver::do_factorize(const BlockMatrix& matrix) {
  const Eigen::MatrixXd dense = to_dense(matrix);
  factor_->llt.compute(dense);
  if (factor_->llt.info() != Eigen::Success) return Status::singular;
  for (Eigen::Index k = 0; k < dense.rows(); ++k) {
    const double root = factor_->llt.matrixLLT()(k, k);
    if (!is_sound_pivot(root * root, dense(k, k))) return Status::singular;
  }
  return Status::ok;
}

Status DenseSolver::do_solve(const Eigen::VectorXd& rhs, Eigen::VectorXd& x) {
  x = factor_->llt.solve(rhs);
  return Status::ok;
}

}  // namespace dda
