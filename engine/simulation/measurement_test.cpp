// What measurements read of blocks, groups and contacts, against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include "engine/core/allocation_counter.h"
#include "engine/simulation/measured_models.h"
#include "engine/simulation/probes.h"

namespace dda {
namespace {

constexpr double round_off = 1e-12;  // of sums of a few terms

// One block for each stress, side by side without touching.
Model stressed_blocks(const std::vector<Vec3>& stresses) {
  Model model;
  model.materials = {rock()};
  for (std::size_t i = 0; i < stresses.size(); ++i) {
    model.blocks.push_back(rectangle(fmt::format("block {}", i), 2.0 * static_cast<double>(i), 0, 1, 1));
    model.blocks.back().initial_stress = stresses[i];
  }
  model.stages = {stage_of(trapezoidal_integrator(), 1e-4, 10)};
  return model;
}

// Two principal stresses on axes turned by an angle have Mohr's components; measured, they come back.
TEST(PrincipalStresses, AreThoseThatMadeTheStress) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> pressure(-3e6, 1e6);
  std::uniform_real_distribution<double> turn(-std::numbers::pi / 2, std::numbers::pi / 2);
  for (int i = 0; i < 50; ++i) {
    const double a = pressure(random);
    const double b = pressure(random);
    const double larger = std::max(a, b);
    const double smaller = std::min(a, b);
    const double angle = turn(random);
    const Mat2 axes = rotation(angle);
    const Mat2 stress = axes * Vec2(larger, smaller).asDiagonal() * axes.transpose();
    Model model = stressed_blocks({{stress(0, 0), stress(1, 1), stress(0, 1)}});
    for (const Quantity quantity :
         {Quantity::stress_1, Quantity::stress_2, Quantity::stress_angle, Quantity::mean_stress, Quantity::max_shear})
      measure(model, quantity, 0);
    const Simulation simulation = simulation_of(std::move(model));
    const std::vector<double> values = sampled(simulation);
    EXPECT_NEAR(values[0], larger, round_off * 3e6);
    EXPECT_NEAR(values[1], smaller, round_off * 3e6);
    // An angle of a stress known to round-off of 3 MPa, seen in the difference of its principal values.
    EXPECT_NEAR(values[2], angle, round_off * 3e6 / (larger - smaller));
    EXPECT_NEAR(values[3], (larger + smaller) / 2, round_off * 3e6);
    EXPECT_NEAR(values[4], (larger - smaller) / 2, round_off * 3e6);
  }
}

// Blocks of 1 x 1 and 3 x 1 m, the second twice as dense: areas 1 : 3, masses 1 : 6.
Model unequal_blocks() {
  Model model;
  model.materials = {rock(), rock()};
  model.materials[1].density *= 2;
  model.blocks = {rectangle("small", 0, 0, 1, 1), rectangle("apart", 10, 0, 1, 1), rectangle("large", 20, 0, 3, 1)};
  model.blocks[2].material = 1;
  model.blocks[0].initial_stress = {4e6, 0, 1e6};
  model.blocks[2].initial_stress = {0, -8e6, 1e6};
  model.blocks[0].initial_velocity = {7, 0};
  model.blocks[2].initial_velocity = {0, 14};
  model.blocks[2].initial_spin = 0.5;
  model.stages = {stage_of(trapezoidal_integrator(), 1e-5, 10)};
  return model;
}

TEST(MeansOfGroups, WeighStressByAreaAndMotionByMass) {
  Model model = unequal_blocks();
  for (const Quantity quantity : {Quantity::stress_xx, Quantity::stress_yy, Quantity::stress_xy, Quantity::velocity_x,
                                  Quantity::velocity_y, Quantity::kinetic_energy, Quantity::stress_1})
    measure(model, quantity, std::vector<int>{0, 2});
  const Simulation simulation = simulation_of(std::move(model));
  const std::vector<double> values = sampled(simulation);
  const double mass = rock().density;
  EXPECT_NEAR(values[0], 1e6, round_off * 1e6);
  EXPECT_NEAR(values[1], -6e6, round_off * 6e6);
  EXPECT_NEAR(values[2], 1e6, round_off * 1e6);
  EXPECT_NEAR(values[3], 1, round_off);
  EXPECT_NEAR(values[4], 12, round_off * 12);
  const double turning = 6 * mass * (9.0 + 1) / 12 * 0.5 * 0.5 / 2;  // of a rectangle of 3 x 1 m
  EXPECT_NEAR(values[5], mass * 7 * 7 / 2 + 6 * mass * 14 * 14 / 2 + turning, round_off * 6e6);
  EXPECT_NEAR(values[6], -2.5e6 + std::hypot(3.5e6, 1e6), round_off * 6e6);  // of the mean stress
}

// The group's centroid falls freely whatever its parts do; its acceleration, velocity and way are those of the fall.
TEST(MeansOfGroups, AreOfTheCommonCentroid) {
  Model model = unequal_blocks();
  for (Block& block : model.blocks) block.initial_stress.setZero();  // shear that is let go turns blocks
  model.gravity = {0, -10};
  for (const Quantity quantity : {Quantity::displacement_x, Quantity::displacement_y, Quantity::velocity_y,
                                  Quantity::acceleration_y, Quantity::rotation})
    measure(model, quantity, std::vector<int>{0, 2});
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 10);
  const double t = simulation.state().time;
  const std::vector<double> values = sampled(simulation);
  EXPECT_NEAR(values[0], 1 * t, round_off);
  EXPECT_NEAR(values[1], 12 * t - 5 * t * t, round_off);
  EXPECT_NEAR(values[2], 12 - 10 * t, round_off * 12);
  EXPECT_NEAR(values[3], -10, 1e-8);  // a second difference over steps of 1e-5 s
  EXPECT_NEAR(values[4], 6.0 / 7 * 0.5 * t, round_off);
}

// All kinetic energy of a scene is that of its ledger, whatever moves in it.
TEST(KineticEnergy, OfAllBlocksIsTheLedgers) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    Model model = shaken_wall(kinematics);
    std::vector<int> all(model.blocks.size());
    std::iota(all.begin(), all.end(), 0);
    measure(model, Quantity::kinetic_energy, all);
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, 20);
    const double energy = sampled(simulation)[0];
    EXPECT_GT(energy, 1);
    EXPECT_NEAR(energy, simulation.energy().kinetic, 1e-10 * energy);
  }
}

// A box of 1 x 0.5 m on a held base, under its weight and a push that its friction bears, or does not; with 1 m/s
// upwards it leaves.
Model box_on_base(const Vec2& push, double upwards = 0) {
  Model model;
  model.materials = {rock()};
  JointMaterial joint;
  joint.law = InterfaceLaw::classical;
  joint.friction_angle = std::atan(0.5);
  model.joints = {joint};
  model.blocks = {rectangle("base", -2, -1, 5, 1), rectangle("box", 0, 0, 1, 0.5)};
  model.blocks[1].initial_velocity = {0, upwards};
  model.held_blocks.resize(1);
  model.gravity = {0, -10};
  model.point_loads = {{1, {0.5, 0.25}, push, Constant{}}};
  model.measurements = {{"contacts", Quantity::contacts}};
  return model;
}

TEST(ContactStatistics, CountCornersThatStickSlideAndAreOpen) {
  const double weight = 10 * rock().density * 0.5;
  struct Case {
    double push, upwards;
    std::vector<double> counts;  // open, sliding, sticking
  };
  for (const Case& each : {Case{0.4, 0, {0, 0, 2}}, Case{0.6, 0, {0, 2, 0}}, Case{0, 1, {2, 0, 0}}}) {
    Model model = box_on_base({each.push * weight, 0}, each.upwards);
    Stage settle = stage_of(static_integrator(), 0.1, 20, Kinematics::small);
    settle.unlimited_strength = true;
    Stage move = stage_of(thesis_integrator(), 1e-3, 20, Kinematics::small);
    model.stages = each.upwards > 0 ? std::vector<Stage>{move} : std::vector<Stage>{settle, move};
    Simulation simulation = simulation_of(std::move(model));
    while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok);
    const std::vector<double> values = sampled(simulation);
    ASSERT_EQ(values.size(), 5U);
    EXPECT_EQ(std::vector<double>(values.begin(), values.begin() + 3), each.counts) << each.push;
  }
}

// Two corner springs of 10 E carry the weight; a static step of a second leaves no inertia in it.
TEST(ContactStatistics, PenetrationIsWhatTheSpringsGiveWayBy) {
  Model model = box_on_base({0, 0});
  model.stages = {stage_of(static_integrator(), 1, 50, Kinematics::small)};
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 50);
  const double weight = 10 * rock().density * 0.5;
  const double stiffness = simulation.contacts().elements[0].stiffness(0);
  // The tolerance is the factor by which fifty steps of M/dt^2 against the springs' stiffness fall short: none is left.
  EXPECT_NEAR(sampled(simulation)[4], weight / (2 * stiffness), 1e-9 * weight / stiffness);
}

TEST(ContactStatistics, PassesAreThoseOfTheStep) {
  Model model = shaken_wall(Kinematics::finite);
  model.measurements = {{"contacts", Quantity::contacts}};
  Simulation simulation = simulation_of(std::move(model));
  std::int64_t before = 0;
  double most = 0;
  EXPECT_EQ(sampled(simulation)[3], 0);
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(simulation.step(), Status::ok);
    const std::int64_t now = simulation.counters().open_close_iterations;
    EXPECT_EQ(sampled(simulation)[3], static_cast<double>(now - before));
    before = now;
    most = std::max(most, sampled(simulation)[3]);
  }
  EXPECT_GT(most, 1);
}

// A block that strains freely swings with omega^2 = 12 E/(rho l^2): strain = rate/omega sin(omega t).
TEST(InitialStrainRate, MakesABlockSwing) {
  Model model = stressed_blocks({Vec3::Zero()});
  model.materials[0].poisson = 0;
  model.blocks[0].initial_strain_rate = {0.1, 0, 0};
  model.stages = {stage_of(trapezoidal_integrator(), 1e-5, 200)};
  measure(model, Quantity::stress_xx, 0);
  Simulation simulation = simulation_of(std::move(model));
  const double omega = std::sqrt(12 * rock().young / rock().density);
  const double amplitude = rock().young * 0.1 / omega;
  const double phase_error = omega * 200e-5 * std::pow(omega * 1e-5, 2) / 12;  // of the trapezoidal rule
  for (int i = 1; i <= 200; ++i) {
    ASSERT_EQ(simulation.step(), Status::ok);
    EXPECT_NEAR(sampled(simulation)[0], amplitude * std::sin(omega * i * 1e-5), 1.1 * phase_error * amplitude) << i;
  }
}

TEST(Measurements, AllocateNothingWhenSampled) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    Model model = shaken_wall(kinematics);
    measure_everything(model);
    Simulation simulation = simulation_of(std::move(model));
    const Probes probes(simulation);
    std::vector<double> values(probes.size());
    run(simulation, 5);
    const long before = allocations_so_far();
    probes.sample(simulation, values);
    EXPECT_EQ(allocations_so_far() - before, 0);
    for (const double value : values) EXPECT_TRUE(std::isfinite(value));
  }
}

}  // namespace
}  // namespace dda
