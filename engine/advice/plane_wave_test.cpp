// Waves in lattices against the continuum they stand for, and the two ways to a wave against each other. Against closed
// forms of chains: verification/sweep.
#include "engine/advice/plane_wave.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/advice/half_row.h"
#include "engine/advice/lattice_test_support.h"

namespace dda {
namespace {

constexpr double pi = std::numbers::pi;

// Relative error of the phase speed with so many blocks in a wavelength.
double speed_error(const Lattice& lattice, WaveKind kind, const Vec2& direction, double blocks) {
  const Stage stage = steps(trapezoidal_integrator(), 1e-4);
  const double speed = continuum_speed(lattice.material, kind);
  const double omega = 2 * pi * speed / (blocks * lattice.offsets[0].norm());
  const auto wave = WaveSolver(lattice, stage, kind, direction).steady({}, omega);
  EXPECT_TRUE(wave.has_value());
  EXPECT_NEAR(wave->wavenumber.imag(), 0, 1e-9 * wave->wavenumber.real());
  return omega / speed / wave->wavenumber.real() - 1;
}

TEST(PlaneWave, SquaresOfTheConsistentLaw) {
  const Lattice lattice = lattice_of(courses(bonded(InterfaceLaw::consistent), 0));
  for (const WaveKind kind : {WaveKind::p, WaveKind::s}) {
    // Along the sides Omega^2/24; what is left out is of fourth order, 0.3 % of it at 40 blocks.
    EXPECT_NEAR(speed_error(lattice, kind, {1, 0}, 40) / (std::pow(2 * pi / 40, 2) / 24), 1, 0.02);
    for (const double degrees : {30.0, 45.0, 80.0}) {
      const Vec2 direction(std::cos(degrees * pi / 180), std::sin(degrees * pi / 180));
      EXPECT_LT(std::abs(speed_error(lattice, kind, direction, 20)), 5e-3) << degrees;  // as promised for the law
    }
  }
}

// S waves at 45 degrees, 20 blocks in a wavelength, springs of 10 E, nu = 0.333: an independent prototype gave +26 %.
TEST(PlaneWave, CornerSpringsLockAlongTheDiagonal) {
  JointMaterial joint = bonded(InterfaceLaw::classical);
  joint.shear_to_normal = 1;
  Lattice lattice = lattice_of(courses(joint, 0));
  lattice.material.poisson = 0.333;
  lattice.material.plane = PlaneState::stress;
  // At the frequency of a wave that is 26 % too fast and 20 blocks long.
  EXPECT_NEAR(speed_error(lattice, WaveKind::s, Vec2(1, 1).normalized(), 20 / 1.26), 0.26, 0.006);
}

TEST(PlaneWave, NoneAboveTheHighestFrequency) {
  const Lattice lattice = lattice_of(row_of_blocks(bonded(InterfaceLaw::classical)));
  const WaveSolver solver(lattice, steps(trapezoidal_integrator(), 1e-4), WaveKind::bar, {1, 0});
  const double speed = continuum_speed(lattice.material, WaveKind::bar);
  EXPECT_TRUE(solver.steady({}, 0.5 * pi * speed).has_value());
  EXPECT_FALSE(solver.steady({}, 2 * pi * speed).has_value());
}

// From joint to joint far from the end only the wave is left, and it advances by exp(-i q step).
TEST(HalfRow, CarriesTheWaveOfTheLattice) {
  const Complex s(200, 900);
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::consistent, InterfaceLaw::cubic}) {
    const Lattice lattice = lattice_of(row_of_blocks(bonded(law)));
    const Stage stage = steps(generalized_alpha_integrator(0.8), 1e-4);
    const Complex square = stepped_square(stage.integrator, stage.dt, s);
    const auto row = HalfRow::make(lattice, stage, WaveKind::bar, {1, 0});
    const WaveSolver solver(lattice, stage, WaveKind::bar, {1, 0});
    const auto wave = solver.near(solver.long_wave(s), square);
    ASSERT_TRUE(row && wave);
    const Complex advance = row->traction(square, 41) / row->traction(square, 40);
    EXPECT_LT(std::abs(advance - std::exp(Complex(0, -1) * wave->wavenumber)), 1e-9);
  }
}

// A slow load arrives as it was sent, exp(-s x/c), for both kinds of waves in a mesh.
TEST(HalfRow, SlowLoadsArriveAsSent) {
  for (const double shift : {0.0, 0.5}) {
    const Lattice lattice = lattice_of(courses(bonded(InterfaceLaw::consistent), shift));
    const Stage stage = steps(trapezoidal_integrator(), 1e-4);
    for (const WaveKind kind : {WaveKind::p, WaveKind::s}) {
      const auto row = HalfRow::make(lattice, stage, kind, {0, 1});
      ASSERT_TRUE(row.has_value());
      EXPECT_NEAR(row->step(), 1, 1e-12);
      const Complex s(5, 30);
      const double speed = continuum_speed(lattice.material, kind);
      const Complex sent = std::exp(-s * 10.0 / speed);
      const double phase = std::abs(s) / speed;  // of a block, whose speed errs by phase^2/24 at most
      EXPECT_LT(std::abs(row->traction(s * s, 10) - sent), 1.2 * 10 * std::pow(phase, 3) / 24);
    }
  }
}

TEST(HalfRow, NeedsAFlatEnd) {
  const Lattice lattice = lattice_of(courses(bonded(InterfaceLaw::consistent), 0));
  const Stage stage = steps(trapezoidal_integrator(), 1e-4);
  EXPECT_FALSE(HalfRow::make(lattice, stage, WaveKind::p, Vec2(1, 1).normalized()).has_value());
  const Lattice bond = lattice_of(courses(bonded(InterfaceLaw::consistent), 0.5));
  EXPECT_FALSE(HalfRow::make(bond, stage, WaveKind::p, {1, 0}).has_value());
}

}  // namespace
}  // namespace dda
