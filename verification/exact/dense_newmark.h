// The oracle where no closed form exists: a dense linear system stepped by any of the schemes, written as plainly as
// possible.
#pragma once

#include <Eigen/Core>
#include <functional>

#include "verification/exact/time_scheme.h"

namespace exact {

// M a + C v + K u = F with n unknowns; all n x n. The matrices need not be symmetric or definite, but M must be
// regular if load(0) is not zero.
struct DenseSystem {
  Eigen::MatrixXd mass;
  Eigen::MatrixXd damping;
  Eigen::MatrixXd stiffness;
};

// Steps from rest (u = v = 0, M a_0 = F_0) and returns observe * u, one column per step 0..steps (q x (steps + 1)).
// `observe` is q x n: rows of the identity for chosen unknowns, or any linear output such as a stress. load(i) is F at
// t = i dt. Throws std::invalid_argument if the sizes disagree.
[[nodiscard]] Eigen::MatrixXd dense_newmark(const DenseSystem& system, const TimeScheme& scheme, double dt, int steps,
                                            const std::function<Eigen::VectorXd(int)>& load,
                                            const Eigen::MatrixXd& observe);

}  // namespace exact
