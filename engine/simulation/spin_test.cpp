// Elastic blocks that spin freely: no integrator gives them energy, and they carry the centrifugal stress.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/geometry/rotation.h"
#include "engine/simulation/simulation_models.h"
#include "engine/terms/inertia.h"

namespace dda {
namespace {

constexpr double width = 1.4;
constexpr double height = 0.8;

Material elastic_rock() { return {"rock", 2500, 20e9, 0.25, PlaneState::stress}; }

Model spinning_block(const Integrator& integrator, double spin, double turn, int steps) {
  Model model;
  model.materials = {elastic_rock()};
  model.blocks = {rectangle("block", 3, -1, width, height)};
  model.blocks[0].initial_velocity = {3, 1};
  model.blocks[0].initial_spin = spin;
  model.stages = {stage_of(integrator, turn / spin, steps, Kinematics::finite)};
  return model;
}

// The strain along the longer side under the mean of its centrifugal stress, rho omega^2 L^2/12.
double centrifugal_strain(double spin) {
  const Material rock = elastic_rock();
  return rock.density * spin * spin * width * width / 12 / rock.young;
}

std::vector<Integrator> all_integrators() {
  return {thesis_integrator(),
          trapezoidal_integrator(),
          hht_integrator(0),
          hht_integrator(0.1),
          hht_integrator(0.3),
          generalized_alpha_integrator(0),
          generalized_alpha_integrator(0.5),
          generalized_alpha_integrator(0.8),
          generalized_alpha_integrator(1),
          energy_conserving_integrator()};
}

double angular_momentum(const Simulation& simulation) {
  const Model& model = simulation.model();
  const State& state = simulation.state();
  const Vec3 squares = deformed_mean_squares(mean_squares(model.blocks[0].moments), state.deformation[0]);
  return momentum({model.mass_of(0), squares, 1}, state.velocity[0])(2);
}

// A slender free block, drawn askew and sheared by half a percent, is let go: it vibrates and turns to and fro with its
// strains, but nothing gives it a spin. (It ended with 3 to 6 rad/s where its inertia followed its shape and its
// angular momentum did not.)
TEST(FreeBlock, VibratesWithoutBeginningToSpin) {
  constexpr double strain = 0.0125;  // gxy of 2 MPa with a shear modulus of 160 MPa
  const Ring box = box_ring(-0.5, -0.15, 0.5, 0.15);
  for (const Integrator& integrator : all_integrators()) {
    Model model;
    model.materials = {{"soft", 2500, 4e8, 0.25, PlaneState::stress}};
    model.blocks.emplace_back().shape.outer = box;
    for (Vec2& corner : model.blocks[0].shape.outer) corner = rotation(0.4) * corner;
    model.blocks[0].initial_stress = {0, 0, 2e6};
    model.stages = {stage_of(integrator, 3e-5, 20'000, Kinematics::finite)};
    Simulation simulation = simulation_of(std::move(model));
    double turned = 0;
    for (int i = 0; i < 20'000; ++i) {
      ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
      turned = std::max(turned, std::abs(simulation.state().displacement[0](2)));
    }
    const EnergyLedger& energy = simulation.energy();
    EXPECT_LT(turned, strain) << integrator.name;  // 0.0073 by H = 0; were all of the swing a turn, twice the strain
    EXPECT_GT(energy.numerical, 0) << integrator.name;  // what is lost
  }
}

// What the engine knows of a spin's change is of first order in the strains, so energies are known to their square, and
// vibrations reach twice the steady strain. The momentum is kept but for a few roundings a step.
class SpinOfElasticBlock : public testing::TestWithParam<double> {};

TEST_P(SpinOfElasticBlock, GainsNoEnergyAndKeepsItsMomentum) {
  constexpr int steps = 4000;
  const double spin = GetParam();
  const double strain = 2 * centrifugal_strain(spin);
  for (const Integrator& integrator : all_integrators()) {
    for (const double turn : {0.1, 0.03, 0.01, 0.001}) {
      Simulation simulation = simulation_of(spinning_block(integrator, spin, turn, steps));
      const double start = simulation.energy().kinetic;
      const double momentum = angular_momentum(simulation);
      double most = 0;
      double change = 0;
      for (int i = 0; i < steps; ++i) {
        ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
        most = std::max(most, (simulation.energy().kinetic + simulation.energy().strain) / start);
        change = std::max(change, std::abs(angular_momentum(simulation) / momentum - 1));
      }
      EXPECT_LT(most - 1, 2 * strain * strain + 1e-12) << integrator.name << " at " << turn << " rad a step";
      EXPECT_LT(change, 1e-10) << integrator.name << " at " << turn << " rad a step";
      EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9) << integrator.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Spins, SpinOfElasticBlock, testing::Values(1.0, 20.0, 200.0));

// Mean stress of a free body: the integral of force times place (virial theorem), for sides a and b rho omega^2 a^2/12
// and rho omega^2 b^2/12. The block is larger than drawn by its strain, which counts twice in the squares of its sides
// and twice in the spin that it leaves. Rules that damp vibrations come to rest there; the others swing about it.
TEST(SpinStress, CarriesTheCentrifugalStress) {
  constexpr double spin = 200;
  for (const double turn : {0.1, 0.01}) {
    Simulation simulation = simulation_of(spinning_block(generalized_alpha_integrator(0), spin, turn, 4000));
    run(simulation, 4000);
    const Vec3 stress = rotate_stress(simulation.state().stress[0], -simulation.state().displacement[0](2));
    const double all = elastic_rock().density * std::pow(simulation.state().velocity[0](2), 2) / 12;
    const double tolerance = 4 * centrifugal_strain(spin) * all * width * width;
    EXPECT_NEAR(stress(0), all * width * width, tolerance);
    EXPECT_NEAR(stress(1), all * height * height, tolerance);
    EXPECT_NEAR(stress(2), 0, tolerance);
  }
}

// Swings from nothing to twice the steady stress: their mean over many is the steady one, at every direction of the
// block, so the recorded stress is that of the moment it is recorded.
TEST(SpinStress, SwingsAboutTheCentrifugalStress) {
  constexpr double spin = 20;
  constexpr int steps = 20000;
  for (const Integrator& integrator : {trapezoidal_integrator(), generalized_alpha_integrator(0.8)}) {
    Simulation simulation = simulation_of(spinning_block(integrator, spin, 0.01, steps));
    Vec3 mean = Vec3::Zero();
    for (int i = 0; i < steps; ++i) {
      ASSERT_EQ(simulation.step(), Status::ok);
      mean += rotate_stress(simulation.state().stress[0], -simulation.state().displacement[0](2)) / steps;
    }
    const double all = elastic_rock().density * spin * spin / 12;
    const double tolerance = 1e-3 * all * width * width;  // what is left of the swings: 1 over their number
    EXPECT_NEAR(mean(0), all * width * width, tolerance) << integrator.name;
    EXPECT_NEAR(mean(1), all * height * height, tolerance) << integrator.name;
    EXPECT_NEAR(mean(2), 0, tolerance) << integrator.name;
  }
}

}  // namespace
}  // namespace dda
