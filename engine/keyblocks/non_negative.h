// Least squares over positive numbers: whether forces that only push, as pressures and sides of cones of friction do,
// can make up what is asked of them.
#pragma once

#include <Eigen/Core>

namespace dda {

// What is left at least of |target - columns * x| over all x >= 0 (Lawson and Hanson 1974). Columns are to be of about
// length 1: what brings less than 1e-12 nearer to the target is not tried.
double least_left(const Eigen::MatrixXd& columns, const Eigen::VectorXd& target);

}  // namespace dda
