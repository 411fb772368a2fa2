#include "verification/exact/nitsche_blocks.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

namespace exact {
namespace {

using Complex = std::complex<double>;
using Matrix = Eigen::MatrixXcd;
using Vec2 = Eigen::Vector2d;

// Blocks of side 1, density 1 and plane modulus E/(1 - nu^2) = 1; x and y from the middle.
constexpr std::array<double, 3> gauss_places = {-0.3872983346207417, 0, 0.3872983346207417};
constexpr std::array<double, 3> gauss_weights = {5.0 / 18, 8.0 / 18, 5.0 / 18};

int functions(const NitscheBlocks& blocks) { return blocks.unknowns() / 2; }

// Monomials and their derivatives in x and y, a row each.
Eigen::Matrix<double, 3, Eigen::Dynamic> monomials(const NitscheBlocks& blocks, const Vec2& at) {
  const double x = at.x(), y = at.y();
  Eigen::Matrix<double, 3, 6> all;
  all << 1, x, y, x * x, x * y, y * y, 0, 1, 0, 2 * x, y, 0, 0, 0, 1, 0, x, 2 * y;
  return all.leftCols(functions(blocks));
}

Eigen::MatrixXd displacement(const NitscheBlocks& blocks, const Vec2& at) {
  const int n = functions(blocks);
  const auto values = monomials(blocks, at);
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(2, 2 * n);
  rows.row(0).head(n) = rows.row(1).tail(n) = values.row(0);
  return rows;
}

Eigen::MatrixXd strain(const NitscheBlocks& blocks, const Vec2& at) {
  const int n = functions(blocks);
  const auto values = monomials(blocks, at);
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(3, 2 * n);
  rows.row(0).head(n) = rows.row(2).tail(n) = values.row(1);
  rows.row(1).tail(n) = rows.row(2).head(n) = values.row(2);
  return rows;
}

Eigen::Matrix3d elasticity(const NitscheBlocks& blocks) {
  Eigen::Matrix3d matrix;
  matrix << 1, blocks.poisson, 0, blocks.poisson, 1, 0, 0, 0, (1 - blocks.poisson) / 2;
  return matrix;
}

Eigen::MatrixXd traction(const NitscheBlocks& blocks, const Vec2& at, const Vec2& normal) {
  Eigen::Matrix<double, 2, 3> on_normal;
  on_normal << normal.x(), 0, normal.y(), 0, normal.y(), normal.x();
  return on_normal * elasticity(blocks) * strain(blocks, at);
}

// The joint towards `normal`, where the next block moves by `phase` times as much as this one.
struct Joint {
  const NitscheBlocks& blocks;
  Vec2 normal;
  Complex phase;

  [[nodiscard]] Vec2 along(double s) const { return s * Vec2(-normal.y(), normal.x()); }
  [[nodiscard]] Matrix gap(double s) const {
    return displacement(blocks, normal / 2 + along(s)) - phase * displacement(blocks, -normal / 2 + along(s));
  }
  [[nodiscard]] Matrix mean_traction(double s) const {
    return (traction(blocks, normal / 2 + along(s), normal) +
            phase * traction(blocks, -normal / 2 + along(s), normal)) /
           2;
  }
  [[nodiscard]] Matrix terms(double s) const {
    const Matrix jump = gap(s), stress = mean_traction(s);
    return blocks.penalty * jump.adjoint() * jump - stress.adjoint() * jump - jump.adjoint() * stress;
  }
  [[nodiscard]] Matrix stiffness() const {
    Matrix sum = Matrix::Zero(blocks.unknowns(), blocks.unknowns());
    if (blocks.mid_edge) {
      const Matrix turn = (gap(0.5) - gap(-0.5)) / 2;
      return terms(0) + blocks.stabilisation * turn.adjoint() * turn;
    }
    for (std::size_t i = 0; i < 3; ++i) sum += gauss_weights[i] * terms(gauss_places[i]);
    return sum;
  }
};

Matrix block_stiffness(const NitscheBlocks& blocks) {
  Matrix sum = Matrix::Zero(blocks.unknowns(), blocks.unknowns());
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Eigen::MatrixXd rows = strain(blocks, {gauss_places[i], gauss_places[j]});
      sum += gauss_weights[i] * gauss_weights[j] * rows.transpose() * elasticity(blocks) * rows;
    }
  return sum;
}

Matrix block_mass(const NitscheBlocks& blocks) {
  Matrix sum = Matrix::Zero(blocks.unknowns(), blocks.unknowns());
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Eigen::MatrixXd rows = displacement(blocks, {gauss_places[i], gauss_places[j]});
      sum += gauss_weights[i] * gauss_weights[j] * rows.transpose() * rows;
    }
  return sum;
}

}  // namespace

SpeedErrors speed_errors(const NitscheBlocks& blocks, double blocks_per_wavelength, double degrees) {
  const double q = 2 * std::numbers::pi / blocks_per_wavelength;
  const double angle = degrees * std::numbers::pi / 180;
  Matrix stiffness = block_stiffness(blocks);
  stiffness += Joint{blocks, {1, 0}, std::polar(1.0, q * std::cos(angle))}.stiffness();
  stiffness += Joint{blocks, {0, 1}, std::polar(1.0, q * std::sin(angle))}.stiffness();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix> waves(stiffness, block_mass(blocks), Eigen::EigenvaluesOnly);
  const Eigen::Vector2d squares = waves.eigenvalues().head<2>();
  if (!(squares(0) > 0)) throw std::invalid_argument("the penalty is too small");
  return {std::sqrt(squares(0)) / q / std::sqrt((1 - blocks.poisson) / 2) - 1, std::sqrt(squares(1)) / q - 1};
}

double worst_speed_error(const NitscheBlocks& blocks, double blocks_per_wavelength) {
  double worst = 0;
  for (double degrees = 0; degrees <= 45; degrees += 7.5) {
    const SpeedErrors errors = speed_errors(blocks, blocks_per_wavelength, degrees);
    worst = std::max({worst, std::abs(errors.s), std::abs(errors.p)});
  }
  return worst;
}

double blocks_needed(const NitscheBlocks& blocks, double error) {
  double few = 2.5, many = 200;
  while (many / few > 1.005) {
    const double middle = std::sqrt(few * many);
    (worst_speed_error(blocks, middle) <= error ? many : few) = middle;
  }
  return many;
}

}  // namespace exact
