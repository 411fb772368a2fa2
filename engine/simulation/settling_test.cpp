// Blocks that a step moves further than contacts are usually looked for, and stages that start with light blocks
// pressed between stiff ones.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr double standard_gravity = 9.81;

// A held floor, and above it a loose stone of the given size.
Model stone_over_floor(double size, double height) {
  Model model;
  model.materials = {{"rock", 2600, 20e9, 0.2, PlaneState::stress}};
  model.joints = {JointMaterial{}};
  model.joints[0].friction_angle = 0.5;
  model.blocks = {rectangle("floor", -2, -1, 4, 1), rectangle("stone", -size / 2, height, size, size)};
  model.held_blocks.emplace_back().block = 0;
  model.gravity = {0, -standard_gravity};
  return model;
}

// Free fall over a static step of 1 s would be 5 m, a hundred times the stone: with its drag it finds the floor.
TEST(Settling, LooseStoneComesToLieOnTheFloor) {
  Model model = stone_over_floor(0.05, 0.002);
  model.stages = {stage_of(static_integrator(), 1, 200, Kinematics::finite)};
  model.stages[0].equilibrium = 1e-9;
  Simulation simulation = simulation_of(std::move(model));
  while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
  EXPECT_LT(simulation.static_out_of_balance()[0], 1e-9);
  // On the floor but for what springs of the automatic stiffness give way under rho g h = 1.3 kPa.
  EXPECT_NEAR(simulation.state().displacement[1](1), -0.002, 1e-7);
  EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
}

// In one step the stone moves by ten times its size, and by a hundred times what contacts are usually looked for from.
TEST(Settling, FastStoneIsStoppedByWhatItWouldPassInOneStep) {
  for (const double size : {1e-1, 1e-2, 1e-3}) {
    Model model = stone_over_floor(size, 0.1);
    model.blocks[1].initial_velocity = {0, -10 * size / 1e-3};
    model.stages = {stage_of(generalized_alpha_integrator(0), 1e-3, 100, Kinematics::finite)};
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, 100);
    EXPECT_GT(simulation.state().displacement[1](1), -0.1 - 0.1 * size) << size;
    const EnergyLedger& energy = simulation.energy();
    EXPECT_LE(energy.kinetic, energy.initial_kinetic + energy.gravity_work) << size;
    // Gaps are differences of coordinates of 0.1 m: the smaller the stone, the more their round-off is of its motion.
    EXPECT_LT(std::abs(energy.relative_residual()), 1e-11 / size) << size;
  }
}

// A pebble wedged between blocks, whose shear of a stage of unlimited strength is let go at its end: the pebble's
// unbalanced force over its mass, times dt, would be a velocity of some hundred metres a second.
TEST(Settling, LetGoShearOfLightBlocksBringsNoEnergy) {
  Model model;
  model.materials = {{"rock", 2600, 20e9, 0.2, PlaneState::stress}};
  model.joints = {JointMaterial{}};
  model.joints[0].friction_angle = 0.02;
  Block wedge;
  wedge.name = "wedge";
  wedge.shape.outer = {{0, 0}, {3, 1.5}, {0, 1.5}};
  Block pebble;
  pebble.name = "pebble";
  pebble.shape.outer = {{-0.01, 0.5}, {0, 0.5}, {0, 0.51}, {-0.01, 0.51}};
  Block floor;
  floor.name = "floor";
  floor.shape.outer = {{0, 0}, {0, -1}, {5, -1}, {5, 2.5}};
  model.blocks = {floor, wedge, rectangle("wall", -1.01, -1, 1, 3), pebble};
  for (const int held : {0, 2}) model.held_blocks.emplace_back().block = held;
  model.gravity = {0, -standard_gravity};
  Stage settle = stage_of(static_integrator(), 1, 20, Kinematics::finite);
  settle.unlimited_strength = true;
  model.stages = {settle, stage_of(generalized_alpha_integrator(0), 1e-3, 5, Kinematics::finite)};
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 20);
  const double stored = simulation.energy().strain + simulation.energy().contact;
  const double fallen = simulation.energy().gravity_work;
  run(simulation, 5);
  const EnergyLedger& energy = simulation.energy();
  EXPECT_LT(energy.kinetic, stored + energy.gravity_work - fallen);
}

}  // namespace
}  // namespace dda
