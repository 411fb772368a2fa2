#include "engine/linear/dense_modes.h"

#include <Eigen/Eigenvalues>

namespace dda {

DenseModes dense_modes(const Eigen::MatrixXd& stiffness) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(stiffness);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

DenseModes dense_modes(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& inertia) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(stiffness, inertia);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace dda
