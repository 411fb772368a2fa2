#include "verification/exact/lined_hole.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

namespace exact {
namespace {

LinedHole tunnel() {
  LinedHole hole;
  hole.radius = 2.5;
  hole.outer_radius = 10;
  hole.rock_young = 5e9;
  hole.rock_poisson = 0.25;
  hole.thickness = 0.2;
  hole.lining_young = 15e9;
  hole.lining_poisson = 0.2;
  hole.stress_xx = -2e6;
  hole.stress_yy = -1e6;
  return hole;
}

TEST(LinedHole, StiffRingsTakeAllOfThePressureAndSoftOnesNone) {
  LinedHole hole = tunnel();
  hole.stress_yy = hole.stress_xx;
  hole.lining_young = 1e18;
  EXPECT_NEAR(lining_forces(hole).thrust_0, 2e6 * hole.radius, 20);
  hole.let_go = 0.4;
  EXPECT_NEAR(lining_forces(hole).thrust_0, 0.6 * 2e6 * hole.radius, 20);
  hole.lining_young = 1;
  EXPECT_NEAR(lining_forces(hole).thrust_0, 0, 20);
  EXPECT_EQ(lining_forces(hole).moment_2, 0);
}

// The same displacements U(r) cos(2 angle), V(r) sin(2 angle) by the least potential energy among those that are
// straight between `rings` + 1 radii, without Navier's equations: Gauss' rule of two points in each ring.
RingForces by_finite_elements(const LinedHole& hole, int rings) {
  const double shear = hole.rock_young / (2 * (1 + hole.rock_poisson));
  const double lame = 2 * shear * hole.rock_poisson / (1 - 2 * hole.rock_poisson);
  Eigen::Matrix3d elastic;
  elastic << lame + 2 * shear, lame, 0, lame, lame + 2 * shear, 0, 0, 0, shear;
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(2 * rings + 2, 2 * rings + 2);
  const double step = (hole.outer_radius - hole.radius) / rings;
  for (int i = 0; i < rings; ++i)
    for (const double place : {0.5 - std::sqrt(1.0 / 12), 0.5 + std::sqrt(1.0 / 12)}) {
      const double r = hole.radius + (i + place) * step;
      const double m = (1 - place) / r;
      const double n = place / r;
      Eigen::Matrix<double, 3, 4> strain;  // radial, hoop, shear of U, V, U, V
      strain << -1 / step, 0, 1 / step, 0, m, 2 * m, n, 2 * n, -2 * m, -1 / step - m, -2 * n, 1 / step - n;
      stiffness.block<4, 4>(2 * i, 2 * i) += strain.transpose() * elastic * strain * r * step / 2;
    }
  const double a = hole.radius;
  const double modulus = hole.lining_young / (1 - hole.lining_poisson * hole.lining_poisson);
  const double bending = modulus * std::pow(hole.thickness, 3) / 12;
  const Eigen::RowVector2d stretch = Eigen::RowVector2d(1, 2) / a;
  const Eigen::RowVector2d bend = Eigen::RowVector2d(4, 2) / (a * a);
  stiffness.topLeftCorner<2, 2>() +=
      a * (modulus * hole.thickness * stretch.transpose() * stretch + bending * bend.transpose() * bend);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * rings + 2);
  const double left = (1 - hole.let_go) * (hole.stress_xx - hole.stress_yy) / 2;
  load.head<2>() << a * left, -a * left;
  const Eigen::VectorXd moved = stiffness.ldlt().solve(load);
  return {0, -modulus * hole.thickness * stretch * moved.head<2>(), -bending * bend * moved.head<2>()};
}

TEST(LinedHole, UnderUnequalStressesIsTheLeastPotentialEnergy) {
  LinedHole hole = tunnel();
  hole.let_go = 0.3;
  for (const double thickness : {0.05, 0.2, 0.4}) {
    hole.thickness = thickness;
    const RingForces forces = lining_forces(hole);
    double coarser = 0;
    for (const int rings : {100, 200}) {
      const RingForces numeric = by_finite_elements(hole, rings);
      EXPECT_NEAR(numeric.thrust_2, forces.thrust_2, 1e-3 * std::abs(forces.thrust_2));
      EXPECT_NEAR(numeric.moment_2, forces.moment_2, 1e-3 * std::abs(forces.moment_2));
      if (rings == 200) {
        EXPECT_NEAR(coarser / (numeric.moment_2 - forces.moment_2), 4, 0.2) << "second order";
      }
      coarser = numeric.moment_2 - forces.moment_2;
    }
  }
}

// Statics of the rock and the ring: the pressure left on the wall is thrust over radius, and the ring is as short.
TEST(LinedHole, ThickAndCrushedRingsAreInBalanceWithTheRock) {
  LinedHole hole = tunnel();
  hole.stress_yy = hole.stress_xx;
  hole.let_go = 0.25;
  const double thrust = lining_forces(hole).thrust_0;
  const double modulus = hole.lining_young / (1 - hole.lining_poisson * hole.lining_poisson);
  const double shortened = thrust / (modulus * hole.thickness) * hole.radius;
  EXPECT_NEAR(crushed_ring(hole, thrust).convergence, shortened, 1e-12);
  EXPECT_NEAR(crushed_ring(hole, thrust).dissipated, 0, 1e-9 * thrust);
  EXPECT_GT(crushed_ring(hole, thrust / 2).dissipated, 0);
  hole.thickness = 1e-4;
  EXPECT_NEAR(thick_ring_thrust(hole) / lining_forces(hole).thrust_0, 1, 1e-4);
}

}  // namespace
}  // namespace exact
