// The corner about which a block rocks stays where friction holds it.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr double width = 1, height = 1.6;  // m
constexpr double spin = -1.8;              // 1/s, about the right toe at first

// A block on a held floor that swings up about its lower right corner, which friction holds all the way.
Model swinging_block(const Integrator& integrator, double dt, double duration) {
  Model model;
  model.materials = {{"rock", 2500, 20e9, 0.2, PlaneState::stress}};
  JointMaterial joint;
  joint.law = InterfaceLaw::classical;
  joint.normal_spring = 2e11;
  joint.friction_angle = 0.9;
  model.joints = {joint};
  model.gravity = {0, -9.81};
  model.blocks = {rectangle("floor", -5, -1, 11, 1), rectangle("block", 0, 0, width, height)};
  model.held_blocks.emplace_back().block = 0;
  model.blocks[1].initial_velocity = {-spin * height / 2, -spin * width / 2};
  model.blocks[1].initial_spin = spin;
  model.stages = {stage_of(integrator, dt, static_cast<int>(std::lround(duration / dt)), Kinematics::finite)};
  return model;
}

// How far the toe has gone along the floor by the end, m.
double creep(const Integrator& integrator, double dt) {
  Simulation simulation = simulation_of(swinging_block(integrator, dt, 0.5));
  while (!simulation.finished()) EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
  const Vec6& moved = simulation.state().displacement[1];
  EXPECT_LT(moved(2), -0.5);  // it has swung up
  const Mat2& turn = simulation.state().deformation[1];
  const Vec2 arm(width / 2, -height / 2);
  return (moved.head<2>() + turn * arm - arm).x();
}

// Rows of the moment to which the balance belongs miss (1/2 - s) r^2 of the arm in each step of the turn r, so the toe
// crept by 0.2 mm at 2 ms, and by half of that at half of the step.
TEST(RockingToe, CreepsToSecondOrderInTheStep) {
  const double coarse = creep(generalized_alpha_integrator(0), 2e-3);
  const double fine = creep(generalized_alpha_integrator(0), 1e-3);
  EXPECT_LT(std::abs(coarse), 2e-6);  // measured: 5.6e-7
  EXPECT_GT(coarse / fine, 3.5);
}

TEST(RockingToe, ComesToTheSamePlaceUnderAllIntegrators) {
  const double damped = creep(generalized_alpha_integrator(0), 1e-3);
  for (const Integrator& other : {thesis_integrator(), energy_conserving_integrator()})
    EXPECT_NEAR(creep(other, 1e-3), damped, 1e-6);
}

}  // namespace
}  // namespace dda
