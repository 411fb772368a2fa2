// Runs of cubic chains whose ends nothing holds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr double pressure = 2e5;    // Pa
constexpr double round_off = 1e-9;  // of static stages: they end at an imbalance of 1e-10
constexpr double width = 0.8;       // m, of bar_of

Model squeezed_bar(const TimeFunction& history) {
  Model model = bar_of(5, bond(InterfaceLaw::cubic));
  model.edge_loads = {{0, {0, width}, {0, 0}, {pressure, 0}, history},
                      {4, {5, 0}, {5, width}, {-pressure, 0}, history}};
  return model;
}

// Stress along the chain anywhere, less what it should be, over that; and the largest of the others.
double stress_error(const Simulation& simulation) {
  double largest = 0;
  for (const Vec3& stress : simulation.state().stress)
    largest = std::max(largest, (stress - Vec3(-pressure, 0, 0)).cwiseAbs().maxCoeff());
  return largest / pressure;
}

TEST(ChainEndRun, UniformPressureIsAStaticState) {
  Model model = squeezed_bar(Constant{});
  model.supports = {{2, {2.5, 0.4}, true, true, 1e9, Vec2::Zero(), {}}};  // nothing else holds the bar
  Stage stage = stage_of(static_integrator(), 1, 40);
  stage.equilibrium = 1e-10;
  model.stages = {stage};
  Simulation simulation = simulation_of(model);
  while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
  EXPECT_LT(stress_error(simulation), round_off);
}

// What is carried from the start is in balance with its loads as well: nothing moves.
TEST(ChainEndRun, InitialStressIsInBalanceWithItsLoads) {
  for (const Integrator& integrator : dynamic_integrators()) {
    Model model = squeezed_bar(Constant{});
    for (Block& block : model.blocks) block.initial_stress = {-pressure, 0, 0};
    model.stages = {stage_of(integrator, 4e-4, 20)};
    Simulation simulation = simulation_of(model);
    run(simulation, 20);
    EXPECT_LT(stress_error(simulation), 1e-12) << integrator.name;
  }
}

// A stage that begins with strains at the ends knows the energy they hold.
TEST(ChainEndRun, EnergyGoesOnFromStageToStage) {
  Model model = squeezed_bar(SineCycles{60, 1.5, 0});
  for (Block& block : model.blocks) block.initial_stress = {-pressure, 3e4, 0};
  model.stages = {stage_of(trapezoidal_integrator(), 4e-4, 15), stage_of(generalized_alpha_integrator(0.8), 2e-4, 30)};
  model.stages[1].correct_time_dispersion = true;
  Simulation simulation = simulation_of(model);
  double worst = 0;
  for (int i = 0; i < 45; ++i) {
    ASSERT_EQ(simulation.step(), Status::ok);
    worst = std::max(worst, std::abs(simulation.energy().relative_residual()));
    if (i == 14) {
      EXPECT_GT(std::abs(simulation.state().stress[0](0) + pressure), 1e-3 * pressure);
    }
  }
  EXPECT_LT(worst, 1e-11);  // forty-five steps, each with a solve of condition 1e3
}

}  // namespace
}  // namespace dda
