// Waves under explicit steps: as the adviser foretells them so they run, and the softened jumps of strains (ADR 24, 49)
// leave errors of fourth order in squares, whatever dt.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/advice/lattice_test_support.h"
#include "engine/advice/plane_wave.h"
#include "engine/advice/wave_errors.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/stability_limit.h"

namespace dda {
namespace {

constexpr int side = 44;  // blocks
constexpr int run_steps = 16;

Stage corrected_explicit_stage(double dt) {
  Stage stage = steps(central_difference_integrator(), dt);
  stage.correct_block_dispersion = stage.correct_time_dispersion = true;
  stage.duration = run_steps * dt;
  return stage;
}

Vec2 towards(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return {std::cos(angle), std::sin(angle)};
}

Model field_of(double shift, const Stage& stage) {
  Model model;
  model.materials = {rock()};
  model.joints = {bonded(InterfaceLaw::consistent)};
  for (int row = 0; row < side; ++row)
    for (int i = 0; i < side; ++i) {
      const double left = i + (row % 2 == 1 ? shift : 0);
      model.blocks.emplace_back().shape.outer = box_ring(left, row, left + 1, row + 1);
    }
  model.stages = {stage};
  finish_model(model);
  return model;
}

// A share of the longest stable dt.
double dt_of(double shift, double share) {
  return share * stability_limit(finished(courses(bonded(InterfaceLaw::consistent), shift)), 0);
}

// The real part of the wave, as velocities at the start.
void set_wave(const PlaneWave& wave, const Vec2& direction, Model& model) {
  const Vec2 middle(side / 2.0, side / 2.0);
  for (Block& block : model.blocks) {
    const double along = direction.dot(block.moments.centroid - middle);
    const ComplexVec6 turned = std::exp(Complex(0, -1) * wave.wavenumber * along) * wave.shape;
    const Vec6 velocity = turned.real();
    block.initial_velocity = velocity.head<2>();
    block.initial_spin = velocity(2);
    block.initial_strain_rate = velocity.tail<3>();
  }
}

// The largest difference of a block in the middle from dt sin(n phi)/sin(phi) times its velocity at the start, over the
// largest displacement: the wave and the one that runs against it, begun from rest in displacements.
double off_course(const PlaneWave& wave, const Vec2& direction, double omega, Model model) {
  set_wave(wave, direction, model);
  const double dt = model.stages[0].dt;
  const std::size_t block = side * (side / 2) + side / 2;
  Simulation simulation(model);
  const Vec6 velocity = simulation.state().velocity[block];
  double off = 0, largest = 0;
  for (int n = 1; n <= run_steps; ++n) {
    EXPECT_EQ(simulation.step(), Status::ok);
    const Vec6 expected = dt * std::sin(n * omega * dt) / std::sin(omega * dt) * velocity;
    off = std::max(off, (simulation.state().displacement[block] - expected).norm());
    largest = std::max(largest, expected.norm());
  }
  return off / largest;
}

TEST(ExplicitWave, RunsAsForetold) {
  for (const double shift : {0.0, 0.5}) {
    const Stage stage = corrected_explicit_stage(dt_of(shift, 0.9));
    const Model model = field_of(shift, stage);
    const Lattice lattice = lattice_of(courses(bonded(InterfaceLaw::consistent), shift));
    for (const WaveKind kind : {WaveKind::p, WaveKind::s}) {
      for (const double degrees : {0.0, 30.0, 45.0}) {
        const Vec2 direction = towards(degrees);
        const double omega = 2 * std::numbers::pi * continuum_speed(lattice.material, kind) / 9;
        const auto wave = WaveSolver(lattice, stage, kind, direction).steady({stage.integrator, stage.dt}, omega);
        ASSERT_TRUE(wave.has_value());
        EXPECT_LT(std::abs(wave->wavenumber.imag()), 1e-9);  // central differences damp nothing
        // What the edges of the field do has not come to its middle but for 1e-7.
        EXPECT_LT(off_course(*wave, direction, omega, model), 1e-6) << degrees << " degrees, shift " << shift;
      }
    }
  }
}

double speed_error(WaveKind kind, double degrees, double blocks_in_wave, double dt) {
  const Lattice lattice = lattice_of(courses(bonded(InterfaceLaw::consistent), 0));
  const WaveQuestion question{lattice, corrected_explicit_stage(dt), kind, towards(degrees), blocks_in_wave};
  const auto errors = steady_errors(question, continuum_speed(lattice.material, kind) / blocks_in_wave);
  return errors ? errors->speed.total() : 1;
}

TEST(ExplicitWave, IsOfFourthOrderInSquaresAtTheLimitOfStability) {
  const double dt = dt_of(0, 0.99);
  for (const WaveKind kind : {WaveKind::p, WaveKind::s}) {
    for (const double degrees : {0.0, 22.5, 45.0}) {
      const double coarse = speed_error(kind, degrees, 20, dt), fine = speed_error(kind, degrees, 40, dt);
      EXPECT_LT(std::abs(coarse), 3e-5) << degrees;  // as in ADR 24 for dt to 0: 0.002 %
      EXPECT_NEAR(std::log2(coarse / fine), 4, 0.15) << degrees;
    }
  }
}

}  // namespace
}  // namespace dda
