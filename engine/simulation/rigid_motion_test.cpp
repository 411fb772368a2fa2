// Motions without strain, and what is conserved.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "engine/simulation/simulation_models.h"
#include "engine/terms/inertia.h"

namespace dda {
namespace {

constexpr double epsilon = 2.2e-16;

Model single_block(const Stage& stage) {
  Model model = model_of({{{{0, 0}, {3, 0.2}, {3.1, 1}, {1.2, 1.1}, {1, 2.5}, {-0.1, 2.4}}, {}}});  // an L
  model.stages = {stage};
  return model;
}

TEST(FreeFall, IsExactForEveryIntegrator) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    for (const Integrator& integrator : dynamic_integrators()) {
      Model model = single_block(stage_of(integrator, 1e-3, 1000, kinematics));
      model.gravity = {0.5, -9.81};
      model.blocks[0].initial_velocity = {2, 3};
      Simulation simulation = simulation_of(std::move(model));
      run(simulation, 1000);
      // Thousand sums of numbers below five, each rounded.
      const Vec2 fallen = simulation.state().displacement[0].head<2>();
      EXPECT_LT((fallen - Vec2(2 + 0.25, 3 - 9.81 / 2)).norm(), 1000 * 5 * epsilon) << integrator.name;
      // A velocity is twice the increment over dt less the one before, each rounded.
      EXPECT_LT((simulation.state().velocity[0].head<2>() - Vec2(2.5, 3 - 9.81)).norm(), 1000 * 3 * 10 * epsilon);
      EXPECT_LT(simulation.state().displacement[0].tail<4>().norm(), 1e-13);
    }
  }
}

TEST(FreeSpin, KeepsAngleAreaAndShapeToRoundOff) {
  constexpr int steps = 10000;
  for (const Integrator& integrator : dynamic_integrators()) {
    Model model = single_block(stage_of(integrator, 1e-3, steps, Kinematics::finite));
    model.materials[0].young = 1e19;  // the centrifugal force stretches it by less than round-off
    model.blocks[0].initial_spin = 7;
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, steps);
    const State& state = simulation.state();
    // Ten thousand sums of numbers up to 70; then as many products of matrices of size one.
    EXPECT_NEAR(state.displacement[0](2), 70, steps * 70 * epsilon) << integrator.name;
    EXPECT_NEAR(state.deformation[0].determinant(), 1, steps * 4 * epsilon);
    EXPECT_LT((state.deformation[0] - rotation(70)).norm(), steps * 80 * epsilon);
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), steps * 4 * epsilon);
  }
}

struct Momentum {
  Vec2 linear = Vec2::Zero();
  double angular = 0;  // about the origin
};

// `moved`: with the blocks where they are now (finite kinematics), or as drawn.
Momentum momentum_of(const Simulation& simulation, bool moved) {
  Momentum sum;
  const Model& model = simulation.model();
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const AreaMoments& moments = model.blocks[i].moments;
    Inertia inertia{model.mass_of(static_cast<int>(i)), mean_squares(moments), 1};
    if (moved) inertia.squares = deformed_mean_squares(inertia.squares, simulation.state().deformation[i]);
    const Vec6 p = momentum(inertia, simulation.state().velocity[i]);
    const Vec2 centroid = moved ? current_centroid(model, simulation.state(), static_cast<int>(i)) : moments.centroid;
    sum.linear += p.head<2>();
    sum.angular += p(2) + centroid.x() * p(1) - centroid.y() * p(0);
  }
  return sum;
}

// A bonded wall of which every block flies its own way.
Model torn_wall(const JointMaterial& joint, const Stage& stage, Pattern pattern, double speed) {
  Model model = grid_of(3, joint, pattern);
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const double phase = 1.7 * static_cast<double>(i);
    model.blocks[i].initial_velocity = speed * Vec2(std::sin(phase) + 0.3, std::cos(2 * phase));
    model.blocks[i].initial_spin = speed * std::sin(3 * phase + 1);
  }
  model.stages = {stage};
  return model;
}

struct Drift {
  double linear, angular;  // relative to the sum of magnitudes
};

Drift momentum_drift(const JointMaterial& joint, const Stage& stage, Pattern pattern, double speed) {
  const bool moved = stage.kinematics == Kinematics::finite;
  Simulation simulation = simulation_of(torn_wall(joint, stage, pattern, speed));
  const Momentum before = momentum_of(simulation, moved);
  run(simulation, 200);
  const Momentum after = momentum_of(simulation, moved);
  const double mass = 2600 * 3 * 3 * 0.7;
  return {(after.linear - before.linear).norm() / (mass * speed),
          std::abs(after.angular - before.angular) / (mass * speed * 3)};
}

TEST(Momentum, IsConservedInSmallKinematics) {
  for (const JointMaterial& joint : {bond(InterfaceLaw::classical), bond(InterfaceLaw::consistent),
                                     strong(InterfaceLaw::classical), strong(InterfaceLaw::consistent)}) {
    for (const Pattern pattern : {Pattern::stack, Pattern::running_bond}) {
      for (const Integrator& integrator : dynamic_integrators()) {
        // 200 solves with a matrix of condition 1e3 to 1e4.
        const Drift drift = momentum_drift(joint, stage_of(integrator, 1e-4, 200), pattern, 0.1);
        EXPECT_LT(drift.linear, 1e-11) << integrator.name;
        EXPECT_LT(drift.angular, 1e-11) << integrator.name;
      }
    }
  }
}

TEST(Momentum, InFiniteKinematicsLinearIsExactAndAngularAsStrainsAreSmall) {
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::consistent}) {
    const Stage stage = stage_of(generalized_alpha_integrator(0.8), 1e-4, 200, Kinematics::finite);
    // Speeds of 0.1 m/s give strains of v/c = 2e-4; arms follow the blocks a step late and forces act on either side of
    // a gap, so that the moment is in error by that share.
    const Drift drift = momentum_drift(bond(law), stage, Pattern::stack, 0.1);
    EXPECT_LT(drift.linear, 1e-11);
    EXPECT_LT(drift.angular, 2e-4);
    // A tenth of the speed, a tenth of the error.
    const Drift slower = momentum_drift(bond(law), stage, Pattern::stack, 0.01);
    EXPECT_LT(slower.angular, 0.2 * drift.angular);
  }
}

TEST(NotFinite, EndsWithAStatusAndKeepsTheState) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    Model model = bar_of(3, bond(InterfaceLaw::classical));
    model.point_loads = {{0, {0.5, 0.4}, {1e300, 0}, PiecewiseLinear{{0, 1e-3, 2e-3}, {0, 0, 1e300}}}};
    model.stages = {stage_of(trapezoidal_integrator(), 1e-3, 10, kinematics)};
    Simulation simulation = simulation_of(std::move(model));
    ASSERT_EQ(simulation.step(), Status::ok);
    const State before = simulation.state();
    EXPECT_EQ(simulation.step(), Status::not_finite);
    EXPECT_FALSE(simulation.message().empty());
    EXPECT_EQ(simulation.state().step, before.step);
    EXPECT_EQ(simulation.state().time, before.time);
    EXPECT_EQ(simulation.state().displacement[0], before.displacement[0]);
  }
}

TEST(Singular, OverflowingMatrixEndsWithAStatus) {
  Model model = bar_of(3, bond(InterfaceLaw::classical));
  model.joints[0].spring_over_young = 1e305;
  model.stages = {stage_of(thesis_integrator(), 1e-3, 10)};
  Simulation simulation = simulation_of(std::move(model));
  const Status status = simulation.step();
  EXPECT_TRUE(status == Status::singular || status == Status::not_finite) << to_string(status);
  EXPECT_FALSE(simulation.message().empty());
}

}  // namespace
}  // namespace dda
