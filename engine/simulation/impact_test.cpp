// Impacts that give back what they took, impacts that are damped, and gravity turned on without sliding.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr double standard_gravity = 9.81;
constexpr double degree = std::numbers::pi / 180;
constexpr double spring = 2e7;  // N/m, soft beside the block: 5e9 N/m

// A box of 1 m above a held floor, dry contacts on springs soft enough for the box to stay without vibrations.
Model box_over_floor(double height, double contact_damping) {
  Model model;
  model.materials = {{"rock", 2600, 5e9, 0.2, PlaneState::stress}};
  JointMaterial joint;
  joint.law = InterfaceLaw::classical;
  joint.normal_spring = spring;
  joint.contact_damping = contact_damping;
  model.joints = {joint};
  model.blocks = {rectangle("floor", -2, -1, 5, 1), rectangle("box", 0, height, 1, 1)};
  for (const double x : {-2.0, 3.0})
    for (const double y : {-1.0, 0.0})
      model.supports.push_back({0, {x, y}, true, true, 5e13, Vec2::Zero(), Constant{}});
  return model;
}

// Height the box comes back to after its first impact, over the height it fell from.
double rebound(const Integrator& integrator, double dt, double* energy_drift = nullptr) {
  constexpr double height = 0.05;
  Model model = box_over_floor(height, 0);
  model.gravity = {0, -standard_gravity};
  const double fall = std::sqrt(2 * height / standard_gravity);
  model.stages = {stage_of(integrator, dt, static_cast<int>(3 * fall / dt), Kinematics::finite)};
  Simulation simulation = simulation_of(std::move(model));
  double highest = -1;
  bool met = false;
  while (!simulation.finished()) {
    EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
    const double lift = simulation.state().displacement[1](1);
    met = met || lift < -height;
    if (met) highest = std::max(highest, lift);
    // Held corners are stiff: what their round-off makes of the energy of the fall.
    EXPECT_LT(std::abs(simulation.energy().residual()), 1e-11 * 2600 * standard_gravity * height);
  }
  if (energy_drift) *energy_drift = simulation.energy().numerical / simulation.energy().scale();
  return 1 + highest / height;
}

TEST(ElasticBounce, ComesBackToItsHeight) {
  for (const double dt : {2e-3, 1e-3, 3e-4, 1e-4}) {
    double drift = 1;
    // The box keeps vibrating with (its period / the impact's)^2, 1e-4 of the energy or so.
    EXPECT_NEAR(rebound(energy_conserving_integrator(), dt, &drift), 1, 1e-3) << dt;
    EXPECT_LT(std::abs(drift), 1e-6) << dt;
  }
}

TEST(ElasticBounce, OtherIntegratorsDoNot) { EXPECT_LT(rebound(thesis_integrator(), 1e-3), 0.9); }

// Restitution of a damped spring that does not pull, by its own motion until spring and dashpot carry nothing:
// Schwager & Poeschel 2007, https://doi.org/10.1007/s10035-007-0065-z, for a damping ratio z < 1/sqrt(2).
double restitution(double z) {
  const double w = std::sqrt(1 - z * z);
  return std::exp(-z / w * (std::numbers::pi - std::atan(2 * z * w / (1 - 2 * z * z))));
}

TEST(DampedBounce, RestitutionIsThatOfASpringWithADashpot) {
  const double damping = 0.2;
  const double z = damping * std::sqrt(2);  // two contacts on one mass
  for (const double dt : {4e-4, 2e-4}) {
    Model model = box_over_floor(1e-3, damping);
    model.blocks[1].initial_velocity = {0, -1};
    model.stages = {stage_of(energy_conserving_integrator(), dt, static_cast<int>(0.04 / dt), Kinematics::finite)};
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, static_cast<int>(0.04 / dt));
    const double error = simulation.state().velocity[1](1) / restitution(z) - 1;
    EXPECT_LT(std::abs(error), 0.02) << dt;
    EXPECT_GT(simulation.energy().dashpot, 0.5 * simulation.energy().initial.kinetic * (1 - restitution(z)));
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-11);
  }
}

// ---- A block of 2 m that leans on its lower left corner and is let go, by Housner's angle times `share`.

struct Rocking {
  double slenderness = 4;
  double share = 0.5;
  double spring = 2e8;  // N/m
  double damping = 1;
  double friction_angle = 0.8;
};

Model rocking_block(const Rocking& of, const Stage& stage) {
  Model model = box_over_floor(0, of.damping);
  model.materials[0].young = 50e9;
  model.joints[0].normal_spring = of.spring;
  model.joints[0].friction_angle = of.friction_angle;
  model.gravity = {0, -standard_gravity};
  const double height = 2;
  const double width = height / of.slenderness;
  const double tilt = of.share * std::atan(width / height);
  const Vec2 along = width * Vec2(std::cos(tilt), std::sin(tilt));
  const Vec2 up = height * Vec2(-std::sin(tilt), std::cos(tilt));
  model.blocks[1].shape.outer = {Vec2::Zero(), along, along + up, up};
  model.stages = {stage};
  return model;
}

struct EnergyOfRun {
  double risen = 0;   // the most by which all energy was above what it had been before, as a share of the largest term
  double gained = 0;  // what the ledger says of the same run at its end
};

// All energy is what is stored less what weight and supports brought; how losses are told apart does not enter.
EnergyOfRun energy_of(Simulation simulation) {
  EnergyOfRun result;
  double least = std::numeric_limits<double>::infinity();
  while (!simulation.finished()) {
    EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
    const EnergyLedger& e = simulation.energy();
    const double all = e.kinetic + e.strain + e.contact - e.gravity_work - e.external_work;
    least = std::min(least, all);
    result.risen = std::max(result.risen, (all - least) / e.scale());
  }
  result.gained = simulation.energy().gain();
  return result;
}

constexpr double gain_that_ends_a_run = 0.01;  // energy_verdict.cpp
constexpr double gain_that_is_said = 0.001;

// A dashpot's first force is one of full speed, half a step late under the default: what it does not take for that was
// said to be energy from nowhere, up to 11 % of all there was. (Longer steps, which do not resolve an impact on such
// springs, book it as a gain of one step and a loss of the next.)
TEST(DampedRocking, FallingEnergyIsNoGain) {
  constexpr std::array<std::pair<double, double>, 4> springs_and_steps{
      {{2e7, 1e-3}, {2e7, 2e-4}, {2e8, 2e-4}, {2e9, 1e-4}}};
  for (const double slenderness : {2.0, 3.0, 4.0, 6.0})
    for (const auto& [spring, dt] : springs_and_steps)
      for (const double damping : {0.2, 1.0, 3.0}) {
        const Stage stage =
            stage_of(generalized_alpha_integrator(0), dt, static_cast<int>(0.8 / dt), Kinematics::finite);
        const EnergyOfRun energy = energy_of(simulation_of(rocking_block({slenderness, 0.5, spring, damping}, stage)));
        EXPECT_LT(energy.risen, gain_that_is_said) << slenderness << ", " << spring << ", " << damping << ", " << dt;
        EXPECT_LT(energy.gained, gain_that_is_said) << slenderness << ", " << spring << ", " << damping << ", " << dt;
      }
}

// Forces that an integrator carries on past the end of a contact do give energy, dashpots or not.
TEST(DampedRocking, EnergyThatRisesIsAGain) {
  const Stage stage = stage_of(hht_integrator(0.1), 3e-3, 300, Kinematics::finite);
  for (const double damping : {0.0, 0.1, 0.2}) {
    const EnergyOfRun energy = energy_of(simulation_of(rocking_block({6, 0.2, 5e10, damping, 0.2}, stage)));
    EXPECT_GT(energy.risen, gain_that_ends_a_run) << damping;
    EXPECT_GT(energy.gained, gain_that_ends_a_run) << damping;
  }
}

// ---- Gravity turned on in a static stage, then sliding.

Model incline(double friction_angle) {
  Model model = box_over_floor(0, 0);
  model.joints[0].normal_spring = 0;
  model.joints[0].friction_angle = friction_angle;
  model.blocks[0].shape.outer = box_ring(-2, -1, 35, 0);
  model.gravity = standard_gravity * Vec2(std::sin(30 * degree), -std::cos(30 * degree));
  Stage turn_on = stage_of(static_integrator(), 1, 50, Kinematics::finite);
  turn_on.unlimited_strength = true;
  turn_on.equilibrium = 1e-9;
  model.stages = {turn_on, stage_of(thesis_integrator(), 1e-3, 2000, Kinematics::finite)};
  return model;
}

TEST(StaticGravity, ABlockSlidesAsCoulombSays) {
  for (const double angle : {0.0, 5.0, 10.0, 15.0, 20.0, 25.0}) {
    Simulation simulation = simulation_of(incline(angle * degree));
    while (simulation.state().time < 50) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
    EXPECT_LT(simulation.results().out_of_balance[0], 1e-9);
    const double start = simulation.state().displacement[1](0);
    run(simulation, 2000);
    const double exact =
        standard_gravity * (std::sin(30 * degree) - std::cos(30 * degree) * std::tan(angle * degree)) * 2;
    EXPECT_NEAR(simulation.state().displacement[1](0) - start, exact, 1e-5 * exact) << angle;
    // The promise is 1e-8 of the work done; the floor's stiff supports cost some digits of each of 2000 solves.
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
  }
}

TEST(StaticGravity, EndsAtEquilibriumAndSaysWhenItDoesNot) {
  Model model = incline(0);
  Simulation settled = simulation_of(model);
  std::int64_t steps = 0;
  while (settled.state().time < 50) {
    ASSERT_EQ(settled.step(), Status::ok) << settled.message();
    ++steps;
  }
  EXPECT_LT(steps, 20);
  EXPECT_EQ(settled.state().time, 50);
  model.stages[0].equilibrium = 1e-300;
  Simulation never = simulation_of(std::move(model));
  Status status = Status::ok;
  while (status == Status::ok && never.state().step < 50) status = never.step();
  EXPECT_EQ(status, Status::not_in_equilibrium);
  EXPECT_EQ(never.state().step, 50);
  EXPECT_NE(never.message().find("out of balance"), std::string::npos);
}

}  // namespace
}  // namespace dda
