// Stages that change the rock, against what can be worked out by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "engine/core/error.h"
#include "engine/simulation/run_so_far.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double slope = 30 * degree;
constexpr double gravity = 9.81;

JointMaterial rough(double friction_angle, double bond = 0, InterfaceLaw law = InterfaceLaw::classical) {
  JointMaterial joint;
  joint.law = law;
  joint.friction_angle = friction_angle;
  joint.cohesion = joint.tensile_strength = bond;
  return joint;
}

// A block on a slope, drawn flat under an oblique gravity, at rest in the first stage; the second gives the joint
// another strength.
Model block_on_slope(const JointMaterial& joint, const JointMaterial& later, Kinematics kinematics) {
  Model model;
  model.materials = {rock()};
  model.joints = {joint};
  model.blocks = {rectangle("base", -5, -1, 20, 1), rectangle("block", 0, 0, 2, 1)};
  model.held_blocks = {HeldBlock{}};
  model.gravity = gravity * Vec2(std::sin(slope), -std::cos(slope));
  const Integrator damped = generalized_alpha_integrator(0);
  model.stages = {stage_of(static_integrator(), 0.1, 20, kinematics), stage_of(damped, 1e-3, 200, kinematics)};
  model.stages[1].rock.joints = {later};
  return model;
}

double speed_after(Model model) {
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 220);
  EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
  return simulation.state().velocity[1](0);
}

double sliding_acceleration(double friction_angle) {
  return gravity * (std::sin(slope) - std::cos(slope) * std::tan(friction_angle));
}

// After 0.2 s. The first step begins with the forces of the old friction, so that the speed lags by half a step.
void expect_slides(double speed, double friction_angle) {
  const double acceleration = sliding_acceleration(friction_angle);
  EXPECT_NEAR(speed, acceleration * (0.2 - 1e-3 / 2), 1e-5 * acceleration);
}

class ChangedStrength : public testing::TestWithParam<Kinematics> {};

TEST_P(ChangedStrength, BlockSlidesAsItsNewFrictionLetsIt) {
  const double weak = 20 * degree;
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::projected}) {
    const double speed = speed_after(block_on_slope(rough(40 * degree, 0, law), rough(weak, 0, law), GetParam()));
    expect_slides(speed, weak);
  }
}

TEST_P(ChangedStrength, BlockThatHasRoomForItsForcesStays) {
  const double speed = speed_after(block_on_slope(rough(40 * degree), rough(36 * degree), GetParam()));
  EXPECT_LT(std::abs(speed), 1e-9);
}

// A bond that is gone leaves friction.
TEST_P(ChangedStrength, BlockSlidesWhenItsBondIsGone) {
  const double weak = 20 * degree;
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::consistent}) {
    EXPECT_LT(std::abs(speed_after(block_on_slope(rough(weak, 1e6, law), rough(weak, 9e5, law), GetParam()))), 1e-9);
    const double speed = speed_after(block_on_slope(rough(weak, 1e6, law), rough(weak, 0, law), GetParam()));
    expect_slides(speed, weak);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinematics, ChangedStrength, testing::Values(Kinematics::small, Kinematics::finite),
                         [](const auto& each) { return each.param == Kinematics::small ? "small" : "finite"; });

Material with_young(double young) {
  Material material = rock();
  material.young = young;
  return material;
}

// A bar that is pulled by `first`, and by `first` and `second` from 1 s on, as its second stage begins. Traction is
// the same everywhere, so that joints have no part in the strain.
Model pulled_bar(const JointMaterial& joint, double first, double second, const Material& later,
                 Kinematics kinematics) {
  Model model = bar_of(6, joint, with_young(2e10));
  model.supports = {{0, {0, 0}, true, true, 1e13, Vec2::Zero(), {}},
                    {0, {0, 0.8}, true, false, 1e13, Vec2::Zero(), {}}};
  const PiecewiseLinear load{{0, 1, 1.1, 9}, {first, first, first + second, first + second}};
  model.edge_loads = {{5, {6, 0}, {6, 0.8}, {1, 0}, load}};
  model.stages = {stage_of(static_integrator(), 0.1, 10, kinematics),
                  stage_of(static_integrator(), 0.1, 10, kinematics)};
  model.stages[1].rock.materials = {later};
  return model;
}

double stretch_of(Model model) {
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 20);
  EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
  const Vec6& last = simulation.state().displacement[5];
  return last(0) + last(3) / 2 - simulation.state().displacement[0](0) + simulation.state().displacement[0](3) / 2;
}

// Between the middles of the outer faces: the length over the modulus of the moment, load by load.
TEST(ChangedMaterials, NewModuliHoldForNewLoads) {
  const double old_young = 2e10;
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite})
    for (const InterfaceLaw law : {InterfaceLaw::consistent, InterfaceLaw::cubic})
      for (const double young : {8e9, 3e10}) {
        const double first = 1e6, second = 2e6;
        const double stretch = stretch_of(pulled_bar(bond(law), first, second, with_young(young), kinematics));
        const double expected = 6 * (first / old_young + second / young);
        EXPECT_NEAR(stretch, expected, (kinematics == Kinematics::small ? 1e-9 : 1e-3) * expected)
            << young << (law == InterfaceLaw::cubic ? " cubic" : " consistent");
      }
}

TEST(ChangedMaterials, NothingMovesWithoutNewLoads) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    const Model changed = pulled_bar(bond(InterfaceLaw::consistent), 1e6, 0, with_young(5e9), kinematics);
    const double expected = 6 * 1e6 / 2e10;
    EXPECT_NEAR(stretch_of(changed), expected, (kinematics == Kinematics::small ? 1e-9 : 1e-3) * expected);
  }
}

// What stresses store with the new modulus instead of the old one is work of whatever changed it.
TEST(ChangedMaterials, StoredEnergyIsBooked) {
  Simulation simulation =
      simulation_of(pulled_bar(bond(InterfaceLaw::consistent), 1e6, 0, with_young(5e9), Kinematics::small));
  run(simulation, 10);
  const EnergyLedger before = energy_at_ends_of_stages(simulation)[0];
  run(simulation, 10);
  EXPECT_NEAR(simulation.energy().strain, 4 * before.strain, 1e-9 * before.strain);
  EXPECT_NEAR(simulation.energy().external_work - before.external_work, 3 * before.strain, 1e-9 * before.strain);
}

TEST(RockOfStage, RefusesWhatAStageCannotChange) {
  const auto refused = [](const JointMaterial& joint, const JointMaterial& later) {
    return refusal_of(block_on_slope(joint, later, Kinematics::small));
  };
  EXPECT_NE(refused(rough(0.5), rough(0.5, 1e6)).find("has no bond"), std::string::npos);
  const char* alone = "strength and the springs of joints alone";
  JointMaterial rising = rough(0.5);
  rising.dilation_angle = 0.1;
  EXPECT_NE(refused(rough(0.5), rising).find(alone), std::string::npos);
  EXPECT_NE(refused(rough(0.5), bond(InterfaceLaw::classical)).find(alone), std::string::npos);
  const auto refused_young = [](double young, const JointMaterial& joint) {
    return refusal_of(pulled_bar(joint, 1, 0, with_young(young), Kinematics::small));
  };
  EXPECT_EQ(refused_young(3.9e10, bond(InterfaceLaw::consistent)), "accepted");
  EXPECT_NE(refused_young(4.1e10, bond(InterfaceLaw::consistent)).find("at most 2 times"), std::string::npos);
  EXPECT_EQ(refused_young(4e11, bond(InterfaceLaw::classical)), "accepted");
  JointMaterial projected = rough(0.5, 0, InterfaceLaw::projected);
  EXPECT_NE(refused_young(1e10, projected).find("projected"), std::string::npos);
}

TEST(RockOfStage, NamesTheStageThatAsksForWhatItRefuses) {
  const auto expect_named = [](Model model) {
    model.stages[1].name = "weak";
    const std::string refusal = refusal_of(model);
    EXPECT_EQ(refusal.find("stages \"weak\" "), 0U) << refusal;
  };
  JointMaterial rising = rough(0.5);
  rising.dilation_angle = 0.1;
  for (const JointMaterial& later : {rising, rough(0.5, 1e6), rough(-1)})
    expect_named(block_on_slope(rough(0.5), later, Kinematics::small));
  for (const double young : {-1.0, 4.1e10})
    expect_named(pulled_bar(bond(InterfaceLaw::consistent), 1, 0, with_young(young), Kinematics::small));
}

}  // namespace
}  // namespace dda
