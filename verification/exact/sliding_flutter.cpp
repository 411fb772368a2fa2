#include "verification/exact/sliding_flutter.h"

#include <Eigen/Dense>

namespace exact {
namespace {

using Matrix = Eigen::Matrix<double, 6, 6>;
using Row = Eigen::Matrix<double, 1, 6>;

// Displacements at (x, y) from the centroid: along the plane u - r y + ex x + gxy y/2, off it v + r x + ey y + gxy x/2.
Row along(double x, double y) { return Row(1, 0, -y, x, 0, y / 2); }
Row off(double x, double y) { return Row(0, 1, x, 0, y, x / 2); }

// Mass matrix by Simpson's rule in x and y, exact for what is quadratic.
Matrix mass(const SlidingBlock& block) {
  const double weights[3] = {1.0 / 6, 4.0 / 6, 1.0 / 6};
  Matrix matrix = Matrix::Zero();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double x = (i - 1) * block.width / 2;
      const double y = (j - 1) * block.height / 2;
      const double share = block.density * block.width * block.height * weights[i] * weights[j];
      matrix += share * (along(x, y).transpose() * along(x, y) + off(x, y).transpose() * off(x, y));
    }
  }
  return matrix;
}

Matrix stiffness(const SlidingBlock& block, double mu) {
  Matrix matrix = Matrix::Zero();
  const double plane = block.young / (1 - block.poisson * block.poisson) * block.width * block.height;
  matrix(3, 3) = matrix(4, 4) = plane;
  matrix(3, 4) = matrix(4, 3) = block.poisson * plane;
  matrix(5, 5) = (1 - block.poisson) / 2 * plane;
  const double y = -block.height / 2;
  for (const double x : {-block.width / 2, block.width / 2})
    matrix += block.normal_spring * (off(x, y) - mu * along(x, y)).transpose() * off(x, y);
  return matrix;
}

}  // namespace

std::complex<double> fastest_growth(const SlidingBlock& block, double mu) {
  const Matrix rates = mass(block).llt().solve(stiffness(block, mu));
  const Eigen::EigenSolver<Matrix> solver(rates, false);
  std::complex<double> fastest = 0;
  for (const std::complex<double>& square : solver.eigenvalues()) {
    const std::complex<double> omega = std::sqrt(square);  // q = exp(i omega t), and its conjugate grows
    if (std::abs(omega.imag()) > fastest.real()) fastest = {std::abs(omega.imag()), omega.real()};
  }
  return fastest;
}

}  // namespace exact
