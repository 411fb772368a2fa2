#include "engine/linear/solver.h"

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

void LinearSolver::check_matrix(const BlockMatrix& matrix) const {
  if (matrix.unknowns() != unknowns_ || matrix.couplings() != couplings_) {
    throw std::logic_error("LinearSolver: factorize needs an analyze of a matrix with this pattern before it");
  }
}

Status LinearSolver::factorize(const BlockMatrix& matrix) {
  check_matrix(matrix);
  ++counts_.factorizations;
  const Status status = matrix.size() > 0 ? do_factorize(matrix) : Status::ok;
  factored_ = status == Status::ok;
  part_factored_ = false;
  return status;
}

Status LinearSolver::factorize(const BlockMatrix& matrix, const BlockPart& part) {
  check_matrix(matrix);
  ++counts_.factorizations;
  const Status status = do_factorize_part(matrix, part);
  factored_ = false;
  part_factored_ = status == Status::ok;
  return status;
}

Status LinearSolver::do_factorize_part(const BlockMatrix&, const BlockPart&) {
  throw std::logic_error("LinearSolver: this one takes no parts");
}

void LinearSolver::check_vectors(bool factored, const Eigen::VectorXd& rhs, const Eigen::VectorXd& x) const {
  if (!factored) throw std::logic_error("LinearSolver: solve needs a factorize with status ok before it");
  if (rhs.size() != unknowns_ || x.size() != unknowns_ || &rhs == &x) {
    throw std::logic_error("LinearSolver: solve needs two different vectors with the length of the matrix");
  }
}

Status LinearSolver::solve(const Eigen::VectorXd& rhs, Eigen::VectorXd& x) {
  check_vectors(factored_, rhs, x);
  ++counts_.solves;
  return unknowns_ > 0 ? do_solve(rhs, x) : Status::ok;
}

double LinearSolver::precondition(const Eigen::VectorXd& r, Eigen::VectorXd& z) {
  check_vectors(factored_ || part_factored_, r, z);
  return unknowns_ > 0 ? do_precondition(r, z) : 0;
}

double LinearSolver::do_precondition(const Eigen::VectorXd& r, Eigen::VectorXd& z) {
  return do_solve(r, z) == Status::ok ? r.dot(z) : 0;
}

}  // namespace dda
