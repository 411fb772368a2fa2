#include "engine/model/material.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

namespace dda {
namespace {

constexpr double round_off = 1e-14;  // relative, of a handful of multiplications

Material rock(PlaneState plane) { return {"rock", 2650, 50e9, 0.25, plane}; }

// Strain under a uniaxial stress in x: (1, -nu) / E in plane stress, the plane-strain constants otherwise.
TEST(Elasticity, PlaneStressStretchesByYoungsModulus) {
  const Vec3 strain(1 / 50e9, -0.25 / 50e9, 0);
  const Vec3 stress = elasticity_matrix(rock(PlaneState::stress)) * strain;
  EXPECT_NEAR(stress.x(), 1, round_off);
  EXPECT_NEAR(stress.y(), 0, round_off);
  EXPECT_EQ(stress.z(), 0);
}

TEST(Elasticity, PlaneStrainIsStifferByOneMinusPoissonSquared) {
  const double modulus = 50e9 / (1 - 0.25 * 0.25);
  const double ratio = 0.25 / (1 - 0.25);
  const Vec3 stress = elasticity_matrix(rock(PlaneState::strain)) * Vec3(1 / modulus, -ratio / modulus, 0);
  EXPECT_NEAR(stress.x(), 1, round_off);
  EXPECT_NEAR(stress.y(), 0, round_off);
}

TEST(Elasticity, LateralStressIsPoissonTimesTheDirectOneWhenHeld) {
  const Vec3 in_stress = elasticity_matrix(rock(PlaneState::stress)) * Vec3(1, 0, 0);
  EXPECT_NEAR(in_stress.y() / in_stress.x(), 0.25, round_off);
  const Vec3 in_strain = elasticity_matrix(rock(PlaneState::strain)) * Vec3(1, 0, 0);
  EXPECT_NEAR(in_strain.y() / in_strain.x(), 1.0 / 3, round_off);
}

TEST(Elasticity, ShearModulusIsTheSameInBothStates) {
  for (const PlaneState plane : {PlaneState::stress, PlaneState::strain}) {
    EXPECT_NEAR(elasticity_matrix(rock(plane))(2, 2), 20e9, round_off * 20e9);
  }
}

TEST(Elasticity, IsSymmetricAndPositiveDefiniteUpToTheLimits) {
  for (const double poisson : {-0.9, 0.0, 0.25, 0.499}) {
    for (const PlaneState plane : {PlaneState::stress, PlaneState::strain}) {
      const Mat3 matrix = elasticity_matrix({"rock", 1, 1, poisson, plane});
      EXPECT_EQ(matrix, matrix.transpose());
      EXPECT_GT(Eigen::SelfAdjointEigenSolver<Mat3>(matrix).eigenvalues().minCoeff(), 0) << poisson;
    }
  }
}

// Thesis chapter 3: sqrt(50 GPa / 2650 kg/m3), printed digits of the digest.
TEST(WaveSpeeds, BarOfTheThesis) { EXPECT_NEAR(bar_wave_speed(rock(PlaneState::stress)), 4343.72, 0.005); }

TEST(WaveSpeeds, DependOnThePlaneStateAsTheModuliDo) {
  const double bar = bar_wave_speed(rock(PlaneState::stress));
  EXPECT_NEAR(p_wave_speed(rock(PlaneState::stress)), bar / std::sqrt(1 - 0.0625), round_off * bar);
  EXPECT_NEAR(p_wave_speed(rock(PlaneState::strain)), bar * std::sqrt(0.75 / (1.25 * 0.5)), round_off * bar);
}

// A bar in plane strain strains sideways by -nu/(1 - nu) of its own strain, so that its sides are free of stress.
TEST(WaveSpeeds, BarInPlaneStrainHasFreeSides) {
  for (const double poisson : {0.0, 0.3, 0.49, 0.499}) {
    const Material material{"rock", 2400, 25e9, poisson, PlaneState::strain};
    const Vec3 stress = elasticity_matrix(material) * Vec3(1, -poisson / (1 - poisson), 0);
    EXPECT_NEAR(stress(1), 0, 1e-13 * elasticity_matrix(material)(0, 0));
    EXPECT_NEAR(bar_wave_speed(material), std::sqrt(stress(0) / 2400), 1e-10 * bar_wave_speed(material)) << poisson;
  }
}

// The thesis' Eq. 12 as printed, sqrt(E / (rho (1 + nu))), is sqrt(2) times this.
TEST(WaveSpeeds, ShearWaveHasTheFactorTwo) {
  EXPECT_NEAR(s_wave_speed(rock(PlaneState::stress)), std::sqrt(50e9 / (2 * 2650 * 1.25)), 1e-10);
  EXPECT_EQ(s_wave_speed(rock(PlaneState::stress)), s_wave_speed(rock(PlaneState::strain)));
}

// Plane-strain P speed over S speed is sqrt(3) at nu = 1/4.
TEST(WaveSpeeds, PoissonSolid) {
  const Material material = rock(PlaneState::strain);
  EXPECT_NEAR(p_wave_speed(material) / s_wave_speed(material), std::numbers::sqrt3, 10 * round_off);
}

}  // namespace
}  // namespace dda
