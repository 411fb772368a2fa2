// Areas, arms and loads follow the blocks in finite kinematics.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

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

}  // namespace
}  // namespace dda
