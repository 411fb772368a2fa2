#include "dda/linear/solver.h"

#include <stdexcept>

namespace dda {

void LinearSolver::analyze(const BlockMatrix& matrix) {
  factored_ = false;
  unknowns_ = -1;
  if (matrix.size() > 0) do_analyze(matrix);
  unknowns_ = matrix.unknowns();
  couplings_ = matrix.couplings();
  ++counts_.analyses;
}

Status LinearSolver::factorize(const BlockMatrix& matrix) {
  if (matrix.unknowns() != unknowns_ || matrix.couplings() != couplings_) {
    throw std::logic_error("LinearSolver: factorize needs an analyze of a matrix with this pattern before it");
  }
  ++counts_.factorizations;
  const Status status = matrix.size() > 0 ? do_factorize(matrix) : Status::ok;
  factored_ = status == Status::ok;
  return status;
}

void LinearSolver::check_vectors(const Eigen::VectorXd& rhs, const Eigen::VectorXd& x) const {
  if (!factored_) throw std::logic_error("LinearSolver: solve needs a factorize with status ok before it");
  if (rhs.size() != unknowns_ || x.size() != unknowns_ || &rhs == &x) {
    throw std::logic_error("LinearSolver: solve needs two different vectors with the length of the matrix");
  }
}

Status LinearSolver::solve(const Eigen::VectorXd& rhs, Eigen::VectorXd& x) {
  check_vectors(rhs, x);
  ++counts_.solves;
  return unknowns_ > 0 ? do_solve(rhs, x) : Status::ok;
}

double LinearSolver::precondition(const Eigen::VectorXd& r, Eigen::VectorXd& z) {
  check_vectors(r, z);
  return unknowns_ > 0 ? do_precondition(r, z) : 0;
}

double LinearSolver::do_precondition(const Eigen::VectorXd& r, Eigen::VectorXd& z) {
  return do_solve(r, z) == Status::ok ? r.dot(z) : 0;
}

}  // namespace dda
