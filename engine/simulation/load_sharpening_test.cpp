// Loads on blocks whose inertia is lowered to make up for the period error of the steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/contact/make_contacts.h"
#include "engine/simulation/external_forces.h"
#include "engine/simulation/linear_operators.h"
#include "engine/simulation/simulation_models.h"
#include "engine/waves/wave_corrections.h"

namespace dda {
namespace {

constexpr double width = 0.8;    // m, of bar_of
constexpr double push = 1e5;     // Pa
constexpr double dt = 6e-4;      // s; 0.37 of a block
constexpr double period = 0.04;  // s, of the push; 25 blocks long

// A bar pushed at its left end by one period of (1 - cos)/2.
Model pushed_bar(const Integrator& integrator, bool corrected) {
  Model model = bar_of(60, bond(InterfaceLaw::cubic));
  PiecewiseLinear history;
  for (int i = 0; i * dt < 2 * period; ++i) {
    const double t = std::min(i * dt, period);
    history.times.push_back(i * dt);
    history.values.push_back((1 - std::cos(2 * std::numbers::pi * t / period)) / 2);
  }
  model.edge_loads = {{0, {0, width}, {0, 0}, {push, 0}, history}};
  Stage stage = stage_of(integrator, dt, 100);
  stage.correct_time_dispersion = corrected;
  stage.lateral_inertia = false;
  model.stages = {stage};
  return model;
}

// The largest velocity of a block over what the push makes in a bar without blocks and steps, less 1.
double velocity_error(const Model& unfinished) {
  Simulation simulation = simulation_of(unfinished);
  const double impedance = std::sqrt(rock().young * rock().density);
  double largest = 0;
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(simulation.step(), Status::ok);
    largest = std::max(largest, simulation.state().velocity[10](0));
  }
  EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-11);
  return largest * impedance / push - 1;
}

TEST(LoadSharpening, WavesHaveTheStrengthOfTheirLoad) {
  for (const Integrator& integrator : {trapezoidal_integrator(), generalized_alpha_integrator(0.8)}) {
    // Without sharpening the peak is too low by this: epsilon dt^2 times the second derivative of the push there.
    const double lost = period_error(integrator) / 2 * std::pow(2 * std::numbers::pi * dt / period, 2);
    EXPECT_GT(lost, 6e-4);
    EXPECT_LT(std::abs(velocity_error(pushed_bar(integrator, true))), 0.2 * lost) << integrator.name;
  }
}

TEST(LoadSharpening, ActsOnTheLoadsOfCorrectedBlocks) {
  Model model = pushed_bar(trapezoidal_integrator(), true);
  model.edge_loads[0].history = SineCycles{10, 4, 0};
  model.blocks.emplace_back().shape.outer = box_ring(0, 10, 1, 11);  // alone
  model.point_loads = {{60, {0.5, 10.5}, {7, 0}, SineCycles{10, 4, 0}}};
  finish_model(model);
  const WaveCorrections waves(model, model.stages[0], make_contacts(model));
  const State start = initial_state(model);
  ExternalForces forces(model, start, waves);
  forces.filter(waves);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(6 * 61);
  const auto sine = [](double t) { return std::sin(2 * std::numbers::pi * 10 * t); };
  for (const double t : {dt, 0.02}) {
    const double bend = sine(t - dt) - 2 * sine(t) + sine(t + dt);
    forces.loads_at(t, force);
    EXPECT_NEAR(force(0), push * width * (sine(t) - bend / 6), 1e-9) << t;
    EXPECT_NEAR(force(360), 7 * sine(t), 1e-13);
  }
}

// What a plan says of the corrections: where joints are consistent (or cubic, for the steps) and nothing can change.
TEST(StepPlan, TellsWhichCorrectionsAct) {
  const auto said = [](InterfaceLaw law, bool bonded, const Integrator& integrator) {
    Model model = bar_of(3, bond(law));
    model.joints[0].bonded = bonded;
    model.stages = {stage_of(integrator, 1e-4, 1)};
    model.stages[0].correct_block_dispersion = model.stages[0].correct_time_dispersion = true;
    const Simulation simulation = simulation_of(std::move(model));
    return std::pair(simulation.plan().waves.for_blocks, simulation.plan().waves.for_steps);
  };
  const Integrator trapezoidal = trapezoidal_integrator();
  EXPECT_EQ(said(InterfaceLaw::consistent, true, trapezoidal), std::pair(true, true));
  EXPECT_EQ(said(InterfaceLaw::consistent, true, static_integrator()), std::pair(false, false));
  EXPECT_EQ(said(InterfaceLaw::cubic, true, trapezoidal), std::pair(false, true));
  EXPECT_EQ(said(InterfaceLaw::classical, true, trapezoidal), std::pair(false, false));
  EXPECT_EQ(said(InterfaceLaw::consistent, false, trapezoidal), std::pair(false, false));
}

// A stage that is not corrected sees the load as given.
TEST(LoadSharpening, EndsWithItsStage) {
  Model model = pushed_bar(trapezoidal_integrator(), true);
  model.edge_loads[0].history = SineCycles{400, 40, 0};  // bends much in a step
  model.stages[0].duration = 4 * dt;
  model.stages.push_back(stage_of(trapezoidal_integrator(), dt, 1));
  Simulation simulation = simulation_of(model);
  run(simulation, 4);
  const double work_before = simulation.energy().external_work;
  const Vec6 before = simulation.state().displacement[0];
  run(simulation, 1);
  const Vec6 moved = simulation.state().displacement[0] - before;
  const auto load = [](double t) { return push * width * std::sin(2 * std::numbers::pi * 400 * t); };
  // Loads on the end of a chain have this share of their lever (ADR 20).
  constexpr double end_share = (10 - std::numbers::sqrt2) / 12;
  const double work = (load(4 * dt) + load(5 * dt)) / 2 * (moved(0) - end_share * 0.5 * moved(3));
  EXPECT_NEAR(simulation.energy().external_work - work_before, work, 1e-9 * std::abs(work));
}

}  // namespace
}  // namespace dda
