// Stages that change the springs of joints or the density of the rock, against what can be worked out by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/simulation/memory_test_support.h"
#include "engine/simulation/run_so_far.h"
#include "engine/simulation/simulation_models.h"

namespace dda {
namespace {

constexpr double gravity = 9.81;
constexpr double width = 2, height = 1;

struct Case {
  const char* name;
  bool bonded;
  Kinematics kinematics;
  InterfaceLaw law = InterfaceLaw::classical;
};

void PrintTo(const Case& each, std::ostream* out) {
  *out << each.name;
}  // NOLINT(readability-identifier-naming): gtest's

const Case cases[] = {{"linear", true, Kinematics::small},
                      {"bonded_moving", true, Kinematics::finite},
                      {"dry_as_drawn", false, Kinematics::small},
                      {"dry_moving", false, Kinematics::finite},
                      {"projected_as_drawn", false, Kinematics::small, InterfaceLaw::projected},
                      {"projected_moving", false, Kinematics::finite, InterfaceLaw::projected}};

JointMaterial springs(double normal, double shear, const Case& each) {
  JointMaterial joint;
  joint.law = each.law;
  joint.bonded = each.bonded;
  joint.friction_angle = 1.2;
  joint.normal_stiffness = normal;
  joint.shear_stiffness = shear;
  return joint;
}

constexpr double normal_stiffness = 2e9, shear_stiffness = 7e8;

// A block on a fixed one, pressed by one load, and by a second one in the third stage; the second stage has other
// springs. Uniform tractions: the block's own strain is the same whatever the joint is.
Model pressed_block(const Case& each, const JointMaterial& later, const Vec2& first, const Vec2& second) {
  Model model;
  model.materials = {rock()};
  model.joints = {springs(normal_stiffness, shear_stiffness, each)};
  model.blocks = {rectangle("base", 0, -1, width, 1), rectangle("block", 0, 0, width, height)};
  model.held_blocks = {HeldBlock{}};
  model.point_loads = {{1, {width / 2, 0}, first, Constant{}}, {1, {width / 2, 0}, second, Constant{}, {2, -1}}};
  for (int i = 0; i < 3; ++i) model.stages.push_back(stage_of(static_integrator(), 0.1, 15, each.kinematics));
  model.stages[1].rock.joints = {later};
  return model;
}

std::vector<Vec2> bottoms_at_ends_of_stages(const Model& model) {
  Simulation simulation = simulation_of(model);
  std::vector<Vec2> bottoms;
  for (std::size_t stage = 0; stage < 3; ++stage) {
    while (stages_done(simulation) == stage) EXPECT_EQ(simulation.step(), Status::ok) << simulation.message();
    bottoms.push_back(point_displacement(simulation.model(), simulation.state(), 1, {width / 2, 0}));
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
  }
  return bottoms;
}

class ChangedSprings : public testing::TestWithParam<Case> {};

// The block's own weightless strain under a load at its bottom is in the gap at its middle as well: only the joint's
// part changes with the joint, so two stiffnesses are compared.
TEST_P(ChangedSprings, MoveNothingUntilLoadsChangeAndAreNewThen) {
  const Vec2 first(2e5, -1e6), second(1e5, -6e5);
  for (const double factor : {0.5, 3.0}) {
    const JointMaterial later = springs(factor * normal_stiffness, factor * shear_stiffness, GetParam());
    const std::vector<Vec2> bottoms = bottoms_at_ends_of_stages(pressed_block(GetParam(), later, first, second));
    const std::vector<Vec2> as_before = bottoms_at_ends_of_stages(
        pressed_block(GetParam(), springs(normal_stiffness, shear_stiffness, GetParam()), first, second));
    EXPECT_LT((bottoms[1] - bottoms[0]).norm(), 1e-12 * height);
    const Vec2 stiffness = width * Vec2(shear_stiffness, normal_stiffness);
    const Vec2 more = (1 / factor - 1) * second.cwiseQuotient(stiffness);
    const double tolerance = (GetParam().kinematics == Kinematics::small ? 1e-8 : 2e-3) * more.norm();
    EXPECT_LT(((bottoms[2] - as_before[2]) - more).norm(), tolerance) << factor;
  }
}

// f^2/(2 k) of the springs: what the force stores otherwise is work of whatever changed them.
TEST_P(ChangedSprings, BookWhatTheyStoreOtherwise) {
  const Vec2 load(0, -1e6);
  Simulation simulation = simulation_of(
      pressed_block(GetParam(), springs(normal_stiffness / 2, shear_stiffness, GetParam()), load, {0, 0}));
  run(simulation, 45);
  const EnergyLedger before = energy_at_ends_of_stages(simulation)[0], after = energy_at_ends_of_stages(simulation)[1];
  const double stored = load.squaredNorm() / (2 * normal_stiffness * width);
  EXPECT_NEAR(after.external_work - before.external_work, stored, 2e-3 * stored);
  EXPECT_NEAR(after.contact - before.contact, stored, 2e-3 * stored);
}

TEST_P(ChangedSprings, ComeBackToWhatTheyWere) {
  const JointMaterial was = springs(normal_stiffness, shear_stiffness, GetParam());
  const Vec2 first(2e5, -1e6), second(1e5, -6e5);
  Model there =
      pressed_block(GetParam(), springs(normal_stiffness / 5, shear_stiffness * 3, GetParam()), first, second);
  there.stages[2].rock.joints = {was};
  const std::vector<Vec2> back = bottoms_at_ends_of_stages(there);
  const std::vector<Vec2> same = bottoms_at_ends_of_stages(pressed_block(GetParam(), was, first, second));
  // Where blocks are followed they are so only when they have moved by 1e-6 of their size, here at other moments.
  const double tolerance = GetParam().kinematics == Kinematics::small ? 1e-10 : 1e-7;
  EXPECT_LT((back[2] - same[2]).norm(), tolerance * same[2].norm());
}

INSTANTIATE_TEST_SUITE_P(Kinds, ChangedSprings, testing::ValuesIn(cases),
                         [](const auto& each) { return std::string(each.param.name); });

Material of_density(double density) {
  Material material = rock();
  material.density = density;
  return material;
}

// Blocks above each other on a fixed one; the second stage has another density.
Model column(const JointMaterial& joint, Kinematics kinematics, double factor) {
  Model model;
  model.materials = {rock()};
  model.joints = {joint};
  model.blocks = {rectangle("base", 0, -1, width, 1)};
  for (int i = 0; i < 5; ++i) model.blocks.push_back(rectangle(std::to_string(i), 0, i * height, width, height));
  model.held_blocks = {HeldBlock{}};
  model.gravity = {0, -gravity};
  for (int i = 0; i < 2; ++i) model.stages.push_back(stage_of(static_integrator(), 1, 20, kinematics));
  model.stages[1].rock.materials = {of_density(factor * rock().density)};
  return model;
}

std::vector<JointMaterial> joints_of_columns() {
  JointMaterial dry = springs(normal_stiffness, shear_stiffness, cases[3]);
  JointMaterial projected;
  projected.law = InterfaceLaw::projected;
  projected.friction_angle = 1.2;
  return {bond(InterfaceLaw::consistent), bond(InterfaceLaw::classical), dry, projected};
}

TEST(ChangedDensity, ColumnGoesDownByTheWeight) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite})
    for (const JointMaterial& joint : joints_of_columns())
      for (const double factor : {2.0, 0.25}) {
        Simulation simulation = simulation_of(column(joint, kinematics, factor));
        run(simulation, 20);
        const State settled = simulation.state();
        run(simulation, 20);
        const State& heavy = simulation.state();
        // In finite kinematics to the size of the strains, up to 1e-4 in all blocks and springs together.
        const double tolerance = kinematics == Kinematics::small ? 1e-8 : 1e-3;
        for (std::size_t i = 1; i <= 5; ++i) {
          EXPECT_NEAR(heavy.displacement[i](1) / settled.displacement[i](1), factor, tolerance * factor);
          EXPECT_NEAR(heavy.stress[i](1) / settled.stress[i](1), factor, tolerance * factor);
        }
        EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
      }
}

// In free fall nothing shows but the energy.
TEST(ChangedDensity, KeepsVelocities) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
    Model model = column(springs(normal_stiffness, shear_stiffness, cases[3]), kinematics, 3);
    model.blocks.resize(2);
    model.blocks[1] = rectangle("block", 0, 50, width, height);
    model.stages = {stage_of(generalized_alpha_integrator(0.5), 1e-3, 100, kinematics),
                    stage_of(generalized_alpha_integrator(0.5), 1e-3, 100, kinematics)};
    model.stages[1].rock.materials = {of_density(3 * rock().density)};
    Simulation simulation = simulation_of(std::move(model));
    run(simulation, 100);
    const double kinetic = simulation.energy().kinetic;  // as it was, or as it is: the stage has begun
    const double mass = width * height * rock().density, speed = gravity * 0.1;
    EXPECT_NEAR(simulation.state().velocity[1](1), -speed, 1e-12);
    EXPECT_NEAR(kinetic, 3 * mass * speed * speed / 2, 1e-9 * kinetic);
    EXPECT_NEAR(simulation.energy().external_work, 2 * mass * speed * speed / 2, 1e-9 * kinetic);
    run(simulation, 100);
    EXPECT_NEAR(simulation.state().velocity[1](1), -2 * speed, 1e-12);
    EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
  }
}

// A projected joint that gapes: a block that its load, at x = 0.4 of the half width, tilts and opens the joint. The
// change alone moves nothing, also when it is back. Where blocks are followed the load, which keeps its direction, has
// a share along the joint of the turn, 3e-3. The end that gapes can carry nothing of it, which lets its points move it.
TEST(ChangedSprings, MoveNothingWhereAProjectedJointGapes) {
  for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite})
    for (const double factor : {0.2, 6.0}) {
      const Case projected{"projected", false, kinematics, InterfaceLaw::projected};
      Model model =
          pressed_block(projected, springs(factor * normal_stiffness, shear_stiffness, projected), {0, -1e6}, {0, 0});
      model.stages[2].rock.joints = {springs(normal_stiffness, 2 * shear_stiffness, projected)};
      for (PointLoad& load : model.point_loads) load.point.x() = 0.85 * width;
      Simulation simulation = simulation_of(model);
      run(simulation, 15);
      const auto& status = simulation.interface_state(0).status;
      ASSERT_NE(status[0] == ContactStatus::open, status[1] == ContactStatus::open);
      const double tolerance = kinematics == Kinematics::small ? 1e-9 : 3e-4;
      const Vec6 settled = simulation.state().displacement[1];
      EXPECT_GT(std::abs(settled(2)), 1e-5);
      run(simulation, 30);
      EXPECT_LT((simulation.state().displacement[1] - settled).norm(), tolerance * settled.norm()) << factor;
      EXPECT_LT(std::abs(simulation.energy().relative_residual()), 1e-9);
    }
}

TEST(ChangedSprings, RefuseWhatWouldLoseForces) {
  const auto refused = [](const JointMaterial& joint, const JointMaterial& later) {
    Model model = pressed_block(cases[3], later, {0, -1}, {0, 0});
    model.joints = {joint};
    return refusal_of(model);
  };
  const JointMaterial by_area = springs(1e9, 1e8, cases[3]);
  JointMaterial by_contact = by_area;
  by_contact.normal_stiffness = by_contact.shear_stiffness = 0;
  EXPECT_NE(refused(by_area, by_contact).find("kind of stiffness"), std::string::npos);
  JointMaterial smooth = by_contact;
  smooth.shear_to_normal = 0;
  EXPECT_NE(refused(by_contact, smooth).find("would be lost"), std::string::npos);
  EXPECT_EQ(refused(smooth, by_contact), "accepted");
  JointMaterial projected = by_area, softer = by_area;
  projected.law = softer.law = InterfaceLaw::projected;
  softer.normal_stiffness = 1e8;
  EXPECT_EQ(refused(projected, softer), "accepted");
  projected.normal_stiffness = projected.shear_stiffness = 0;
  EXPECT_NE(refused(projected, softer).find("kind of stiffness"), std::string::npos);
}

}  // namespace
}  // namespace dda
