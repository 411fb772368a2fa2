// Damping in proportion to inertia and stiffness: every vibration of a scene fades as the oscillator that it is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "engine/contact/make_contacts.h"
#include "engine/linear/dense_modes.h"
#include "engine/simulation/linear_operators.h"
#include "engine/simulation/simulation_models.h"
#include "engine/simulation/support_set.h"

namespace dda {
namespace {

constexpr double mass_damping = 40;         // 1/s
constexpr double stiffness_damping = 2e-5;  // s

Model held_grid(double dt, int steps, const Integrator& integrator) {
  Model model = grid_of(3, bond(InterfaceLaw::consistent));
  for (int i = 0; i < 3; ++i)
    for (const double x : {0.0, 1.0}) model.supports.push_back({i, {i + x, 0}, true, true, 2e9, Vec2::Zero(), {}});
  for (std::size_t i = 0; i < model.blocks.size(); ++i)
    model.blocks[i].initial_velocity = {std::sin(1.0 + static_cast<double>(i)), std::cos(2.0 * static_cast<double>(i))};
  model.stages = {stage_of(integrator, dt, steps)};
  model.stages[0].material_damping.mass = mass_damping;
  model.stages[0].material_damping.stiffness = stiffness_damping;
  finish_model(model);
  return model;
}

Eigen::MatrixXd dense(const BlockMatrix& matrix) {
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(matrix.unknowns(), matrix.unknowns());
  Eigen::VectorXd column(matrix.unknowns());
  for (int i = 0; i < matrix.unknowns(); ++i) {
    matrix.multiply(Eigen::VectorXd::Unit(matrix.unknowns(), i), column);
    all.col(i) = column;
  }
  return all;
}

// The oracle: M u'' + C u' + K u = 0 by its vibrations, each exp(-r w t) sin(w sqrt(1 - r^2) t).
Eigen::VectorXd exact_displacement(const Model& model, double time) {
  const ContactSet contacts = make_contacts(model);
  const LinearOperators operators(model, make_block_terms(model), contacts, make_supports(model, initial_state(model)),
                                  WaveCorrections(model, model.stages[0], contacts));
  const DenseModes modes = dense_modes(dense(operators.stiffness.matrix()), dense(operators.inertia.matrix()));
  Eigen::VectorXd velocity = Eigen::VectorXd::Zero(operators.inertia.unknowns());
  for (std::size_t i = 0; i < model.blocks.size(); ++i)
    velocity.segment<2>(static_cast<Eigen::Index>(6 * i)) = model.blocks[i].initial_velocity;
  Eigen::VectorXd amplitude = modes.shapes.transpose() * dense(operators.inertia.matrix()) * velocity;
  for (Eigen::Index k = 0; k < amplitude.size(); ++k) {
    const double omega = std::sqrt(modes.squares(k));
    const double rate = (mass_damping + stiffness_damping * omega * omega) / 2;  // r w
    const std::complex<double> damped = std::sqrt(std::complex<double>(omega * omega - rate * rate));
    amplitude(k) *= std::exp(-rate * time) * (std::sin(damped * time) / damped).real();
  }
  return modes.shapes * amplitude;
}

double error_at_end(double dt, const Integrator& integrator) {
  constexpr double time = 4e-3;  // s, a period and a half of the slowest vibration
  const int steps = static_cast<int>(std::lround(time / dt));
  const Model model = held_grid(dt, steps, integrator);
  const Eigen::VectorXd exact = exact_displacement(model, time);
  Simulation simulation(model);
  run(simulation, steps);
  Eigen::VectorXd got(exact.size());
  for (std::size_t i = 0; i < model.blocks.size(); ++i)
    got.segment<6>(static_cast<Eigen::Index>(6 * i)) = simulation.state().displacement[i];
  return (got - exact).norm() / exact.norm();
}

// The error is of second order: a quarter at half the step.
TEST(RayleighDamping, EveryVibrationFadesAsAnOscillator) {
  for (const Integrator& integrator :
       {trapezoidal_integrator(), hht_integrator(0.1), generalized_alpha_integrator(0.85)}) {
    const double coarse = error_at_end(1e-5, integrator);
    const double fine = error_at_end(5e-6, integrator);
    EXPECT_LT(fine, 0.01) << integrator.name;
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.2) << integrator.name;
  }
}

// A sine travels along a bar of 0.2 m blocks; over 20 m its amplitude falls by exp(-k x), k = 2 pi r/wavelength.
TEST(RayleighDamping, AWaveLosesItsShareOverEachWavelength) {
  constexpr double frequency = 400;
  constexpr double ratio = 0.02;
  double peaks[2];
  for (const bool damped : {false, true}) {
    Model model;
    model.materials = {{"rock", 2500, 20e9, 0.25, PlaneState::stress}};
    model.joints = {bond(InterfaceLaw::consistent)};
    for (int i = 0; i < 200; ++i) model.blocks.emplace_back().shape.outer = box_ring(0.2 * i, 0, 0.2 * (i + 1), 0.2);
    model.edge_loads = {{0, {0, 0.2}, {0, 0}, {1e6, 0}, SineCycles{frequency, 100, 0}}};
    const double speed = bar_wave_speed(model.materials[0]);
    model.stages = {stage_of(trapezoidal_integrator(), 1e-5, static_cast<int>(55 / speed / 1e-5))};
    if (damped) model.stages[0].material_damping.stiffness = ratio / (std::numbers::pi * frequency);
    Simulation simulation = simulation_of(std::move(model));
    double& peak = peaks[damped ? 1 : 0] = 0;
    while (!simulation.finished()) {
      ASSERT_EQ(simulation.step(), Status::ok);
      if (simulation.state().time > 35 / speed) peak = std::max(peak, std::abs(simulation.state().velocity[100](0)));
    }
    if (!damped) continue;
    const double wavelength = speed / frequency;
    const double expected = std::exp(-2 * std::numbers::pi * ratio * 20.1 / wavelength);
    EXPECT_NEAR(peaks[1] / peaks[0] / expected, 1, 0.003);  // of the size of blocks; ratio^2
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-11);
    EXPECT_GT(simulation.energy().damping, 0);
  }
}

// A grid on its lower left block, which is shaken, with loads drawn at random.
Model shaken_grid(InterfaceLaw law, const Integrator& integrator, MotionKind kind, unsigned seed) {
  Model model = grid_of(3, bond(law));
  model.gravity = {0, -10};
  HeldBlock& held = model.held_blocks.emplace_back();
  held.amplitude = kind == MotionKind::displacement ? Vec2(1e-4, -5e-5) : Vec2(2, -1);
  held.kind = kind;
  held.history = SineCycles{150, 10, 0};
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> force(-1e5, 1e5);
  for (int i = 0; i < static_cast<int>(model.blocks.size()); ++i)
    model.point_loads.push_back(
        {i, model.blocks[static_cast<std::size_t>(i)].shape.outer[2], {force(random), force(random)}, Constant{}});
  model.stages = {stage_of(integrator, 2e-5, 300)};
  model.stages[0].material_damping.mass = mass_damping;
  model.stages[0].material_damping.stiffness = stiffness_damping;
  return model;
}

// What the held block does against the damping of its joints comes in like all it does.
TEST(RayleighDamping, EnergyBalancesWhereABlockIsShaken) {
  unsigned seed = 1;
  for (const InterfaceLaw law : {InterfaceLaw::consistent, InterfaceLaw::classical})
    for (const MotionKind kind : {MotionKind::displacement, MotionKind::velocity, MotionKind::acceleration})
      for (const Integrator& integrator : dynamic_integrators()) {
        Simulation simulation = simulation_of(shaken_grid(law, integrator, kind, ++seed));
        ASSERT_TRUE(simulation.plan().linear);
        run(simulation, 300);
        const EnergyLedger& energy = simulation.energy();
        EXPECT_GT(energy.damping, 1e-4 * energy.scale()) << integrator.name;
        EXPECT_LT(std::abs(energy.relative_residual()), 1e-11) << integrator.name;
      }
}

// Two blocks that move on evenly with what drives them, a block that is held or the feet of supports: nothing deforms,
// and dampers of joints and supports have nothing to do.
Model moving_evenly(bool on_supports, const Integrator& integrator) {
  const Vec2 velocity(0.3, -0.2);
  Model model = bar_of(on_supports ? 2 : 3, bond(InterfaceLaw::consistent));
  for (Block& block : model.blocks) block.initial_velocity = velocity;
  if (on_supports) {
    for (const Vec2& corner : model.blocks[0].shape.outer) {
      PointSupport& support = model.supports.emplace_back(
          PointSupport{0, corner, true, true, 1e10, velocity, Constant{}, MotionKind::velocity});
      if (corner.y() > 0) support.direction = Vec2(0.6, 0.8);
    }
  } else {
    model.blocks[0].initial_velocity.setZero();
    model.held_blocks = {HeldBlock{0, velocity, 0, Vec2::Zero(), Constant{}, MotionKind::velocity}};
  }
  model.stages = {stage_of(integrator, 1e-4, 100)};
  model.stages[0].material_damping.stiffness = 1e-4;
  return model;
}

TEST(RayleighDamping, LeavesWhatMovesAsAWholeAlone) {
  for (const bool on_supports : {false, true})
    for (const Integrator& integrator : dynamic_integrators()) {
      Simulation simulation = simulation_of(moving_evenly(on_supports, integrator));
      run(simulation, 100);
      for (const Vec6& displacement : simulation.state().displacement) {
        EXPECT_LT((displacement.head<2>() - 0.01 * Vec2(0.3, -0.2)).norm(), 1e-12) << integrator.name << on_supports;
        EXPECT_LT(displacement.tail<4>().norm(), 1e-12) << integrator.name << on_supports;
      }
      EXPECT_LT(std::abs(simulation.energy().damping), 1e-9 * simulation.energy().kinetic) << integrator.name;
    }
}

// The same where supports are shaken: what their feet do against the dampers comes in.
TEST(RayleighDamping, EnergyBalancesWhereSupportsAreShaken) {
  for (const MotionKind kind : {MotionKind::displacement, MotionKind::velocity, MotionKind::acceleration})
    for (const Integrator& integrator : dynamic_integrators()) {
      Model model = held_grid(2e-5, 300, integrator);
      for (PointSupport& support : model.supports) {
        support.amplitude = kind == MotionKind::displacement ? Vec2(1e-4, -5e-5) : Vec2(2, -1);
        support.kind = kind;
        support.history = SineCycles{150, 10, 0};
      }
      Simulation simulation = simulation_of(std::move(model));
      run(simulation, 300);
      EXPECT_GT(std::abs(simulation.energy().external_work), 1e-4 * simulation.energy().scale()) << integrator.name;
      EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-11) << integrator.name;
    }
}

}  // namespace
}  // namespace dda
