// Modes of small problems by dense algebra, for tests. Eigen compiles its solver anew in every source that names one,
// some three seconds each; these two functions have it in one place.
#pragma once

#include <Eigen/Core>

namespace dda {

struct DenseModes {
  Eigen::VectorXd squares;  // omega^2, ascending
  Eigen::MatrixXd shapes;   // a column each
};

// K x = omega^2 x of a symmetric matrix.
DenseModes dense_modes(const Eigen::MatrixXd& stiffness);

// K x = omega^2 M x of two symmetric matrices, M positive; x^T M x = 1.
DenseModes dense_modes(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& inertia);

}  // namespace dda
