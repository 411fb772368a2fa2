#include "verification/yardstick/explicit_plate.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

namespace yardstick {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double density = 2650, young = 50e9, poisson = 0.25;

// Stiffness of a wave exp(i q.x) on the endless grid, over the mass of a node. Bilinear squares are products of linear
// elements in x and y: stiffness 2 - 2 cos, mass (4 + 2 cos)/6, mixed derivative i sin (sides of 1).
Eigen::Matrix2d grid_stiffness(const Eigen::Vector2d& angle, double side) {
  const double plane = young / (1 - poisson * poisson), shear = young / (2 * (1 + poisson));
  const Eigen::Array2d cosine = angle.array().cos();
  const Eigen::Array2d k = 2 - 2 * cosine, m = (4 + 2 * cosine) / 6;
  const double mixed = (poisson * plane + shear) * std::sin(angle.x()) * std::sin(angle.y());
  Eigen::Matrix2d stiffness;
  stiffness << plane * k(0) * m(1) + shear * m(0) * k(1), mixed, mixed, shear * k(0) * m(1) + plane * m(0) * k(1);
  return stiffness / (density * side * side);
}

// The middle of a free plate does not know of its edges before they are as many steps away as elements.
void expect_wave(const Eigen::Vector2d& angle, int which, double cfl) {
  const Plate plate{density, young, poisson, 0.5, 40, 40};
  const double dt = cfl * plate.side / std::sqrt(young / (1 - poisson * poisson) / density);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> waves(grid_stiffness(angle, plate.side));
  const Eigen::Vector2d polarisation = waves.eigenvectors().col(which);
  const double omega = 2 / dt * std::asin(dt / 2 * std::sqrt(waves.eigenvalues()(which)));
  ExplicitPlate run(plate, dt, {});
  for (int row = 0; row <= 40; ++row) {
    for (int column = 0; column <= 40; ++column) {
      const Eigen::Vector2d shape = std::cos(angle.dot(Eigen::Vector2d(column - 20, row - 20))) * polarisation;
      run.displacement().col(plate.node(column, row)) = shape;
      run.velocity().col(plate.node(column, row)) = shape * (1 - std::cos(omega * dt)) / dt;
    }
  }
  for (int n = 1; n < 20; ++n) {
    run.step(0);
    const Eigen::Vector2d middle = run.displacement().col(plate.node(20, 20));
    ASSERT_NEAR((middle - std::cos(omega * n * dt) * polarisation).norm(), 0, 1e-12) << angle.transpose() << " " << n;
  }
}

TEST(ExplicitPlate, KeepsTheClosedFormOfDispersion) {
  for (const double degrees : {0.0, 20.0, 45.0, 110.0})
    for (const double size : {0.2, 1.0, 2.5})
      for (const int which : {0, 1})
        expect_wave(size * Eigen::Vector2d(std::cos(degrees * pi / 180), std::sin(degrees * pi / 180)), which, 0.6);
}

// Leading error of the speed of both waves along a side: -(k h)^2/24, so order 2.
TEST(ExplicitPlate, SpeedsConvergeWithOrderTwo) {
  const double shear_speed = std::sqrt(young / (2 * (1 + poisson)) / density);
  const auto error = [&](double angle) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> waves(grid_stiffness({angle, 0}, 1));
    return std::sqrt(waves.eigenvalues()(0)) / angle / shear_speed - 1;
  };
  EXPECT_NEAR(std::log2(error(0.2) / error(0.1)), 2, 0.01);
  EXPECT_NEAR(error(0.1), -0.01 / 24, 1e-6);
}

// Rigid motion and turning cost nothing, uniform strain its energy.
TEST(SquareStiffness, KnowsRigidMotionAndUniformStrain) {
  const Stiffness stiffness = square_stiffness(young, poisson);
  Eigen::Matrix<double, 8, 1> turned, stretched;
  turned << 0, 0, 0, 1, -1, 1, -1, 0;
  stretched << 0, 0, 1, 0, 1, 0, 0, 0;
  EXPECT_LT((stiffness * turned).norm(), 1e-14 * young);
  EXPECT_NEAR(stretched.dot(stiffness * stretched), young / (1 - poisson * poisson), 1e-12 * young);
}

TEST(ExplicitPlate, TakesUpTheImpulse) {
  const Plate plate{density, young, poisson, 0.5, 6, 4};
  const Eigen::Vector2d force(3e5, -1e5);
  ExplicitPlate run(plate, 5e-5, {{plate.node(1, 2), force}});
  for (int n = 0; n < 50; ++n) run.step(2);
  Eigen::Vector2d momentum = Eigen::Vector2d::Zero();
  for (int row = 0; row <= 4; ++row)
    for (int column = 0; column <= 6; ++column) {
      const double share = (column % 6 == 0 ? 0.5 : 1) * (row % 4 == 0 ? 0.5 : 1);
      momentum += share * density * plate.side * plate.side * run.velocity().col(plate.node(column, row));
    }
  EXPECT_LT((momentum - 2 * 50 * 5e-5 * force).norm(), 1e-12 * (100 * 5e-5 * force).norm());
}

}  // namespace
}  // namespace yardstick
