#include "verification/yardstick/explicit_plate.h"

#include <array>
#include <cmath>
#include <utility>

namespace yardstick {
namespace {

using Strains = Eigen::Matrix<double, 3, 8>;  // (ex, ey, gxy) of the eight displacements

constexpr std::array<std::pair<int, int>, 4> corners = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

// At (xi, eta) of the square [-1, 1]^2, for sides of 2.
Strains strains(double xi, double eta) {
  Strains rows = Strains::Zero();
  for (int i = 0; i < 4; ++i) {
    const auto [x, y] = corners[static_cast<std::size_t>(i)];
    const double along_x = x * (1 + y * eta) / 4;
    const double along_y = y * (1 + x * xi) / 4;
    rows(0, 2 * i) = rows(2, 2 * i + 1) = along_x;
    rows(1, 2 * i + 1) = rows(2, 2 * i) = along_y;
  }
  return rows;
}

}  // namespace

Stiffness square_stiffness(double young, double poisson) {
  const double plane = young / (1 - poisson * poisson);
  Eigen::Matrix3d elasticity;
  elasticity << plane, poisson * plane, 0, poisson * plane, plane, 0, 0, 0, plane * (1 - poisson) / 2;
  Stiffness stiffness = Stiffness::Zero();
  const double gauss = 1 / std::sqrt(3.0);
  for (const double xi : {-gauss, gauss})
    for (const double eta : {-gauss, gauss}) stiffness += strains(xi, eta).transpose() * elasticity * strains(xi, eta);
  return stiffness;
}

ExplicitPlate::ExplicitPlate(const Plate& plate, double dt, std::vector<NodeForce> forces)
    : plate_(plate),
      dt_(dt),
      forces_(std::move(forces)),
      stiffness_(square_stiffness(plate.young, plate.poisson)),
      displacement_(Eigen::Matrix2Xd::Zero(2, plate.nodes())),
      velocity_(displacement_),
      force_(displacement_) {
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(plate.nodes());
  const double quarter = plate.density * plate.side * plate.side / 4;
  for (int row = 0; row < plate.rows; ++row)
    for (int column = 0; column < plate.columns; ++column)
      for (const int dx : {0, 1})
        for (const int dy : {0, 1}) mass(plate.node(column + dx, row + dy)) += quarter;
  step_over_mass_ = dt * mass.cwiseInverse();
}

void ExplicitPlate::step(double factor) {
  force_.setZero();
  for (const NodeForce& load : forces_) force_.col(load.node) = factor * load.force;
  add_elements();
  for (int i = 0; i < force_.cols(); ++i) {
    velocity_.col(i) += step_over_mass_(i) * force_.col(i);
    displacement_.col(i) += dt_ * velocity_.col(i);
  }
}

void ExplicitPlate::add_elements() {
  Eigen::Matrix<double, 8, 1> moved;
  for (int row = 0; row < plate_.rows; ++row) {
    for (int column = 0; column < plate_.columns; ++column) {
      const int below = plate_.node(column, row);
      const int above = plate_.node(column, row + 1);
      moved << displacement_.col(below), displacement_.col(below + 1), displacement_.col(above + 1),
          displacement_.col(above);
      const Eigen::Matrix<double, 8, 1> held = stiffness_ * moved;
      force_.col(below) -= held.segment<2>(0);
      force_.col(below + 1) -= held.segment<2>(2);
      force_.col(above + 1) -= held.segment<2>(4);
      force_.col(above) -= held.segment<2>(6);
    }
  }
}

}  // namespace yardstick
