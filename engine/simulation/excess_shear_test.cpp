// Excess shear stress of a joint at any angle in a uniform stress field, against Mohr's circle and Coulomb's law.
#include "engine/simulation/excess_shear.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>

#include "engine/simulation/memory_test_support.h"
#include "engine/simulation/probes.h"
#include "engine/simulation/seen_rock.h"
#include "engine/simulation/simulation_models.h"
#include "engine/simulation/snapshot.h"

namespace dda {
namespace {

// A uniform stress (Pa, tension positive) and the direction of a joint, drawn by lot.
struct Field {
  Vec3 stress = Vec3::Zero();
  double angle = 0;  // rad, of the joint, from x

  [[nodiscard]] Vec2 along() const { return {std::cos(angle), std::sin(angle)}; }
  [[nodiscard]] Vec2 across() const { return {-std::sin(angle), std::cos(angle)}; }
  [[nodiscard]] Vec2 traction(const Vec2& normal) const {
    return {stress(0) * normal.x() + stress(2) * normal.y(), stress(2) * normal.x() + stress(1) * normal.y()};
  }
  // Mohr's circle, from half the sum and half the difference of the normal stresses.
  [[nodiscard]] double normal() const {
    return (stress(0) + stress(1)) / 2 - (stress(0) - stress(1)) / 2 * std::cos(2 * angle) -
           stress(2) * std::sin(2 * angle);
  }
  [[nodiscard]] double shear() const {
    return -(stress(0) - stress(1)) / 2 * std::sin(2 * angle) + stress(2) * std::cos(2 * angle);
  }
  [[nodiscard]] double excess(double cohesion, double friction_angle) const {
    return std::abs(shear()) - std::max(0.0, cohesion - normal() * std::tan(friction_angle));
  }
};

// Compressive, with ratios of principal stresses up to 5.
Field random_field(std::mt19937& generator) {
  std::uniform_real_distribution<double> size(2e6, 10e6), turn(0, M_PI);
  const double first = size(generator), second = size(generator), direction = turn(generator);
  const double mean = -(first + second) / 2, radius = (first - second) / 2;
  Field field;
  field.stress = {mean + radius * std::cos(2 * direction), mean - radius * std::cos(2 * direction),
                  radius * std::sin(2 * direction)};
  field.angle = turn(generator);
  return field;
}

// Two boxes of 2 m by 1 m, above and below a joint through the origin, with the stress in them and its tractions on
// their outsides.
Model jointed(const Field& field, const JointMaterial& joint) {
  Model model;
  model.materials = {rock()};
  model.joints = {joint};
  const Vec2 t = field.along(), n = field.across();
  model.blocks.resize(2);
  model.blocks[0].shape.outer = {-t - n, t - n, t, -t};
  model.blocks[1].shape.outer = {-t, t, t + n, -t + n};
  const auto load = [&](int block, int from, const Vec2& normal) {
    const Ring& ring = model.blocks[static_cast<std::size_t>(block)].shape.outer;
    const auto start = static_cast<std::size_t>(from);
    model.edge_loads.push_back({block, ring[start], ring[(start + 1) % 4], field.traction(normal), Constant{}});
  };
  load(0, 0, -n);
  load(1, 2, n);
  for (const int block : {0, 1}) {
    load(block, 1, t);
    load(block, 3, -t);
  }
  for (Block& block : model.blocks) block.initial_stress = field.stress;
  model.measurements = {
      {"ess", Quantity::excess_shear}, {"weak", Quantity::excess_shear}, {"line", Quantity::excess_shear}};
  model.measurements[1].friction_angle = 0.3;
  model.measurements[1].cohesion = 1e5;
  model.measurements[2].on_line = true;
  model.measurements[2].from = -t;
  model.measurements[2].to = t;
  return model;
}

JointMaterial joint_of(InterfaceLaw law, double cohesion, double friction_angle) {
  JointMaterial joint;
  joint.name = "fault";
  joint.law = law;
  joint.friction_angle = friction_angle;
  joint.cohesion = cohesion;
  joint.tensile_strength = cohesion;
  return joint;
}

// Turned on while joints stick whatever they carry.
Stage stuck(Kinematics kinematics) {
  Stage stage = stage_of(static_integrator(), 1e-3, 4, kinematics);
  stage.unlimited_strength = true;
  return stage;
}

std::vector<double> sampled(const Simulation& simulation) {
  const Probes probes(simulation);
  std::vector<double> values(probes.size());
  probes.sample(simulation, values);
  return values;
}

// By what the end of a stage keeps, and by measurements. `tolerance`: of the stress.
void expect_excess(const Field& field, const JointMaterial& joint, Kinematics kinematics, double tolerance) {
  Model model = jointed(field, joint);
  model.stages = {stuck(kinematics)};
  Simulation simulation = simulation_of(std::move(model));
  run(simulation, 3);
  const std::vector<double> values = sampled(simulation);
  run(simulation, 1);
  const double allowed = tolerance * field.stress.norm();
  const double expected = field.excess(joint.cohesion, joint.friction_angle);
  ASSERT_EQ(simulation.results().excess.size(), 1U);
  const ExcessShear& kept = simulation.results().excess[0];
  EXPECT_NEAR(kept.largest, expected, allowed);
  EXPECT_NEAR(kept.normal, field.normal(), allowed);
  EXPECT_NEAR(std::abs(kept.shear), std::abs(field.shear()), allowed);
  const double in_length = std::max(1e-9, tolerance);
  EXPECT_NEAR(kept.length, 2, in_length);
  EXPECT_NEAR(kept.positive, expected > 0 ? 2 : 0, in_length);
  EXPECT_NEAR(kept.place.norm(), 0, 0.01);
  EXPECT_NEAR(values[0], expected, allowed);
  EXPECT_NEAR(values[2], field.excess(1e5, 0.3), allowed);
  EXPECT_NEAR(values[3], field.excess(1e5, 0.3) > 0 ? 2 : 0, in_length);
  EXPECT_NEAR(values[4], expected, allowed);
}

TEST(ExcessShear, IsCoulombsAtAnyAngleInAUniformField) {
  std::mt19937 generator(16);
  std::uniform_real_distribution<double> cohesion(0, 3e5), friction_angle(0.05, 0.6);
  int positive = 0;
  for (int i = 0; i < 30; ++i) {
    const Field field = random_field(generator);
    const double c = cohesion(generator), phi = friction_angle(generator);
    for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::consistent, InterfaceLaw::projected})
      expect_excess(field, joint_of(law, c, phi), Kinematics::small, 1e-9);
    JointMaterial bonded = joint_of(InterfaceLaw::consistent, c, phi);
    bonded.bonded = true;
    expect_excess(field, bonded, Kinematics::small, 1e-9);
    positive += field.excess(c, phi) > 0 ? 1 : 0;
  }
  EXPECT_GT(positive, 5);
  EXPECT_LT(positive, 25);
}

// Contacts of vertices, which are found anew: geometry follows strains of 1e-3.
TEST(ExcessShear, IsCoulombsOfDryBlocksThatMove) {
  std::mt19937 generator(17);
  for (int i = 0; i < 20; ++i)
    expect_excess(random_field(generator), joint_of(InterfaceLaw::classical, 0, 0.4), Kinematics::finite, 5e-3);
}

// A joint that slides is at its strength, so that nothing is in excess of it.
TEST(ExcessShear, IsNoneWhereJointsSlideAtTheirStrength) {
  std::mt19937 generator(18);
  int slid = 0;
  for (int i = 0; i < 20; ++i) {
    const Field field = random_field(generator);
    Model model = jointed(field, joint_of(InterfaceLaw::classical, 0, 0.2));
    model.stages = {stage_of(generalized_alpha_integrator(0), 1e-5, 20)};
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, 20);
    EXPECT_LT(simulation.results().excess.at(0).largest, 1e-9 * field.stress.norm());
    slid += field.excess(0, 0.2) > 0 ? 1 : 0;
  }
  EXPECT_GT(slid, 3);
}

// Steps leave sliding joints off their strength by round-off to either side, which is no length in excess.
TEST(ExcessShear, IsNoneInRockThatSlidesHereAndThere) {
  for (int kind = 0; kind < cut_kinds; ++kind)
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      Model rock = dry_rock(static_cast<CutKind>(kind), seed);
      rock.joints[0].law = InterfaceLaw::projected;
      rock.joints[0].automatic_stiffness = false;
      rock.stages = {stage_of(generalized_alpha_integrator(0), 1e-3, 10, Kinematics::finite)};
      Simulation simulation = simulation_of(std::move(rock));
      while (!simulation.finished()) ASSERT_EQ(simulation.step(), Status::ok) << simulation.message();
      for (const ExcessShear& joint : simulation.results().excess) {
        EXPECT_EQ(joint.largest, 0) << kind << ", " << seed;
        EXPECT_EQ(joint.positive, 0) << kind << ", " << seed;
      }
    }
}

// A bonded joint without friction and cohesion has no strength that could be exceeded; one that is given counts.
TEST(ExcessShear, OfBondedJointsNeedsAStrength) {
  Field field;
  field.stress = {-5e6, -2e6, 1e6};
  field.angle = 0.5;
  Model model = jointed(field, bond(InterfaceLaw::consistent));
  model.measurements.erase(model.measurements.begin());
  model.measurements.pop_back();
  model.stages = {stuck(Kinematics::small)};
  Simulation simulation = simulation_of(model);
  EXPECT_NEAR(sampled(simulation)[0], field.excess(1e5, 0.3), 1e-9 * field.stress.norm());
  run(simulation, 4);
  EXPECT_TRUE(simulation.results().excess.empty());
}

TEST(ExcessShear, IsRememberedByRunsThatGoOn) {
  std::mt19937 generator(19);
  Model model = jointed(random_field(generator), joint_of(InterfaceLaw::classical, 0, 0.3));
  model.stages = {stuck(Kinematics::finite), stage_of(generalized_alpha_integrator(0), 1e-5, 6, Kinematics::finite)};
  finish_model(model);
  Simulation whole(model);
  run(whole, 6);
  Simulation resumed(model);
  restore(resumed, whole.state(), save(whole));
  for (Simulation* each : {&whole, &resumed}) run(*each, 4);
  EXPECT_EQ(memory_of(resumed), memory_of(whole));
  EXPECT_EQ(resumed.results().excess.size(), 2U);
}

}  // namespace
}  // namespace dda
