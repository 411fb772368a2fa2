// Areas, arms and loads follow the blocks in finite kinematics.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "engine/geometry/rotation.h"
#include "engine/simulation/block_system.h"
#include "engine/simulation/simulation_models.h"
#include "engine/simulation/step_coefficients.h"

namespace dda {
namespace {

TEST(FiniteKinematics, StressBalancesTheTractionOnTheDeformedBlock) {
  // Soft enough to shorten by a tenth: the drawn area would be that much off.
  Model model = model_of({{box_ring(0, 0, 2, 1), {}}}, {"soft", 1000, 1e6, 0.3, PlaneState::stress});
  model.edge_loads = {{0, {2, 1}, {0, 1}, {0, -1e5}, {}}, {0, {0, 0}, {2, 0}, {0, 1e5}, {}}};
  model.stages = {stage_of(static_integrator(), 1, 100, Kinematics::finite)};
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 100);
  EXPECT_GT(std::abs(simulation.state().deformation[0].determinant() - 1), 0.05);
  // Force on the strain: area * stress = traction * length * height, all deformed. Inertia is 1e-3 of the stiffness, so
  // that a hundred steps come to rest.
  EXPECT_NEAR(simulation.state().stress[0](1), -1e5, 1e-6 * 1e5);
  EXPECT_NEAR(simulation.state().stress[0](0), 0, 1e-6 * 1e5);
}

TEST(FiniteKinematics, ArmOfAForceTurnsWithItsBlock) {
  constexpr double dt = 0.02;
  constexpr double force = 3e3;
  Model model = model_of({{box_ring(-0.5, -0.5, 0.5, 0.5), {}}}, {"stiff", 1000, 1e15, 0, PlaneState::stress});
  model.point_loads = {{0, {0.5, 0}, {0, force}, Constant{}}};
  const Integrator integrator = generalized_alpha_integrator(0.5);
  model.stages = {stage_of(integrator, dt, 30, Kinematics::finite)};
  Simulation simulation = simulation_of(std::move(model));
  // The same step by step for a rigid body: torque with the arm of the moment at which the integrator's balance holds,
  // as foreseen at the step's start.
  const StepCoefficients step = step_coefficients(integrator, dt);
  const double inertia = 1000.0 / 6;
  double angle = 0, velocity = 0, acceleration = force * 0.5 / inertia;
  for (int i = 0; i < 30; ++i) {
    ASSERT_EQ(simulation.step(), Status::ok);
    const double torque = force * 0.5 * std::cos(angle + step.acts_at * dt * velocity);
    const double d = (torque / inertia + step.mass_v * velocity + step.mass_a * acceleration) / step.mass;
    const double new_acceleration = step.a_d * d + step.a_v * velocity + step.a_a * acceleration;
    velocity += step.v_a0 * acceleration + step.v_a1 * new_acceleration;
    acceleration = new_acceleration;
    angle += d;
    // Strains of force/E = 1e-12, a solve with entries from 1e2 to 1e15.
    ASSERT_NEAR(simulation.state().displacement[0](2), angle, 1e-9) << "step " << i;
  }
  EXPECT_GT(angle, 0.5);  // far enough for the arm to matter
}

// A block that goes round about a pin a thousand times as stiff as itself. Rows of any one moment miss of the pin's way
// in a step a share of the turn's square; times that stiffness it would be a hundred times the force that the pin has.
TEST(FiniteKinematics, PinOfABlockThatGoesRoundPullsItToTheCentre) {
  constexpr double spin = 10;  // rad/s
  constexpr double dt = 1e-3;  // 0.01 rad a step
  constexpr double density = 1e3;
  for (const Integrator& integrator : {thesis_integrator(), generalized_alpha_integrator(0.85),
                                       generalized_alpha_integrator(0), hht_integrator(0.1)}) {
    Model model = model_of({{box_ring(-0.5, -0.5, 0.5, 0.5), {}}}, {"rock", density, 1e9, 0, PlaneState::stress});
    PointSupport pin;
    pin.block = 0;
    pin.point = {-0.5, 0};
    pin.holds_x = pin.holds_y = true;
    pin.stiffness = 1e12;
    model.supports = {pin};
    model.blocks[0].initial_spin = spin;
    model.blocks[0].initial_velocity = {0, 0.5 * spin};
    constexpr int steps = 1000;
    model.stages = {stage_of(integrator, dt, steps, Kinematics::finite)};
    Simulation simulation = simulation_of(std::move(model));
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
      ASSERT_EQ(simulation.step(), Status::ok);
      const SupportElement& held = simulation.system().supports[0];
      const Vec2 force = -held.stiffness * held.gap;  // on the block
      const double angle = simulation.state().displacement[0](2);
      if (i >= steps / 2) sum += force.dot(rotation(angle) * Vec2(-1, 0)) / (steps - steps / 2);
    }
    EXPECT_NEAR(sum, density * spin * spin * 0.5, 0.02 * density * spin * spin * 0.5) << integrator.name;
  }
}

// A cantilever of bonded blocks is bent, pulled while it is bent, let go of the one and then of the other: strains of
// 1e-3 that come and go around a loop. Gaps that were summed up along rows which turn kept 1e-3 of the stress.
TEST(FiniteKinematics, BondedBlocksForgetAnyWayBackToWhereTheyWere) {
  Model model = grid_of(3, bond(InterfaceLaw::consistent));
  const double force = 1e-3 * model.materials[0].young;
  for (const double y : {0.0, 0.7, 1.4, 2.1}) {
    PointSupport hold;
    hold.block = std::min(static_cast<int>(y / 0.7 + 1e-9), 2) * 3;
    hold.point = {0, y};
    hold.stiffness = 100 * model.materials[0].young;
    model.supports.push_back(hold);
  }
  model.point_loads = {{8, {3, 2.1}, {0, force}, PiecewiseLinear{{0, 1, 2, 3, 4}, {0, 1, 1, 0, 0}}},
                       {8, {3, 2.1}, {force, 0}, PiecewiseLinear{{0, 1, 2, 3, 4}, {0, 0, 1, 1, 0}}}};
  constexpr int steps = 400;
  model.stages = {stage_of(static_integrator(), 0.01, steps + 50, Kinematics::finite)};
  Simulation simulation = simulation_of(std::move(model));
  double largest = 0;
  for (int i = 0; i < steps; ++i) {
    ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
    for (const Vec3& stress : simulation.state().stress) largest = std::max(largest, stress.norm());
  }
  run(simulation, 50);
  EXPECT_GT(largest, force);
  // Strains in the directions of blocks do not commute: of second order in them, 1e-6.
  for (const Vec3& stress : simulation.state().stress) EXPECT_LT(stress.norm(), 1e-5 * largest);
}

}  // namespace
}  // namespace dda
