#include "engine/contact/joint_stiffness.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/contact/block_across.h"
#include "engine/contact/contact_models.h"
#include "engine/contact/interface_element.h"
#include "engine/contact/make_contacts.h"
#include "engine/contact/moving_contacts.h"

namespace dda {
namespace {

// Two blocks of 2 by 1 m above each other, 2600 kg/m3 and 1 GPa.
Model stack(const JointMaterial& joint) {
  Model model = model_of({{box_ring(0, 0, 2, 1), {}}, {box_ring(0, 1, 2, 2), {}}});
  model.joints = {joint};
  model.gravity = {0, -10};
  finish_model(model);
  return model;
}

Springs springs_of_the_joint(const Model& model) { return springs_of(model, find_interfaces(model).at(0)); }

JointMaterial given(double normal, double shear) {
  JointMaterial joint;
  joint.law = InterfaceLaw::classical;
  joint.normal_stiffness = normal;
  joint.shear_stiffness = shear;
  return joint;
}

JointMaterial automatic() {
  JointMaterial joint;
  joint.law = InterfaceLaw::classical;
  joint.automatic_stiffness = true;
  return joint;
}

TEST(JointStiffness, EachEndTakesItsHalf) {
  const Springs both = springs_of_the_joint(stack(given(3e9, 2e9)));
  EXPECT_DOUBLE_EQ(both.normal, 3e9);  // of 2 m
  EXPECT_DOUBLE_EQ(both.shear, 2e9);
  EXPECT_DOUBLE_EQ(springs_of_the_joint(stack(given(3e9, 0))).shear, 0.4 * 3e9);
}

TEST(JointStiffness, SpringsAsBefore) {
  JointMaterial joint = given(0, 0);
  EXPECT_DOUBLE_EQ(springs_of_the_joint(stack(joint)).normal, 10e9);
  joint.normal_spring = 7e8;
  joint.shear_to_normal = 0.5;
  EXPECT_DOUBLE_EQ(springs_of_the_joint(stack(joint)).normal, 7e8);
  EXPECT_DOUBLE_EQ(springs_of_the_joint(stack(joint)).shear, 3.5e8);
}

// A square stone of side `stone` in the middle of a slab of 4 by 1 m.
Springs springs_below(double stone, const JointMaterial& joint) {
  Model model = model_of({{box_ring(0, 0, 4, 1), {}}, {box_ring(2, 1, 2 + stone, 1 + stone), {}}});
  model.joints = {joint};
  finish_model(model);
  return springs_of_the_joint(model);
}

TEST(JointStiffness, SpringsGoByTheSizesOfBlocksWhereNoneIsGiven) {
  JointMaterial joint = given(0, 0);
  joint.spring_over_young = 0;
  EXPECT_DOUBLE_EQ(springs_below(0.2, joint).normal, 10e9);  // of E = 1 GPa; the ratio is 2/0.2
  EXPECT_DOUBLE_EQ(springs_below(0.2, joint).shear, 4e9);
  EXPECT_NEAR(springs_below(0.04, joint).normal, 50e9, 1);
  EXPECT_NEAR(springs_below(0.04, joint).shear, 0.4 * std::sqrt(10 * 50) * 1e9, 1);
  EXPECT_DOUBLE_EQ(springs_below(2e-4, joint).normal, 300e9);
  joint.dilation_angle = 0.1;
  joint.friction_angle = 0.5;
  EXPECT_DOUBLE_EQ(springs_below(0.02, joint).normal, 10e9);
  joint = given(0, 0);
  joint.spring_over_young = 7;
  EXPECT_DOUBLE_EQ(springs_below(0.02, joint).normal, 7e9);
}

TEST(JointStiffness, AMovingContactTakesHalfOfWhatItsEdgesHaveInCommon) {
  Model model = stack(given(3e9, 0));
  ContactSet contacts = make_contacts(model);
  State state = initial_state(model);
  MovingContacts moving(model, state, contacts);
  const auto expect_springs = [&](double length) {
    ASSERT_EQ(contacts.elements.size(), 2U);
    for (const InterfaceElement& element : contacts.elements.own()) {
      EXPECT_NEAR(element.stiffness(0), 3e9 * length / 2, 1) << length;
      EXPECT_NEAR(element.stiffness(1), 0.4 * 3e9 * length / 2, 1) << length;
    }
  };
  expect_springs(2);
  state.displacement[1](0) = 0.5;
  moving.follow(model, state, contacts);
  expect_springs(1.5);
  state.displacement[1](0) = -1.99;  // a corner on a corner: 5 % of the size, sqrt(2) m
  moving.follow(model, state, contacts);
  expect_springs(2 * 0.05 * std::sqrt(2));
}

// Modulus of plane strain of the only material over E.
double confined(const Model& model) { return plane_modulus(model.materials[0]) / model.materials[0].young; }

// M/(k_n L) between equal blocks, and pressure/k_n over their size.
TEST(JointStiffness, ErrorsByHand) {
  const Model model = stack(given(20e9, 0));
  EXPECT_DOUBLE_EQ(model.expected.pressure, 2600 * 10 * 2);
  const StiffnessErrors errors = stiffness_errors(model, find_interfaces(model).at(0));
  EXPECT_NEAR(errors.compliance, confined(model) * 1e9 / 20e9, 1e-15);
  EXPECT_NEAR(errors.penetration, 52e3 / 20e9 / std::sqrt(2), 1e-18);
}

// Whatever the shape, the extent of the scene and the size of its blocks, the two targets are met.
TEST(JointStiffness, ChosenStiffnessMeetsItsTargets) {
  for (const double size : {1e-3, 1.0, 50.0}) {
    for (const double gravity : {0.0, 10.0, 1e4 / size}) {
      for (const double flatness : {0.1, 1.0, 8.0}) {
        Model model = model_of({{box_ring(0, 0, size, flatness * size), {}},
                                {box_ring(0, flatness * size, size, 2 * flatness * size), {}},
                                {box_ring(size, 0, 2 * size, 3 * size), {}}});
        model.joints = {automatic()};
        model.gravity = {0, -gravity};
        finish_model(model);
        for (const Interface& interface : find_interfaces(model)) {
          const StiffnessErrors errors = stiffness_errors(model, interface);
          const double of_free_blocks = errors.compliance / confined(model);
          EXPECT_LE(of_free_blocks, compliance_target) << size << ' ' << gravity << ' ' << flatness;
          EXPECT_LE(errors.penetration, penetration_target) << size << ' ' << gravity << ' ' << flatness;
          const double larger = std::max(of_free_blocks / compliance_target, errors.penetration / penetration_target);
          EXPECT_GT(larger, 0.05) << "much stiffer than asked for: " << size << ' ' << gravity << ' ' << flatness;
        }
      }
    }
  }
}

TEST(JointStiffness, LongStepsSoftenTheChoice) {
  Model model = stack(automatic());
  const double free = springs_of_the_joint(model).normal;
  Stage stage;
  stage.dt = 1e-3;
  stage.duration = 1;
  model.stages = {stage};
  EXPECT_EQ(springs_of_the_joint(model).normal, free);
  model.stages[0].dt = 10;
  EXPECT_DOUBLE_EQ(springs_of_the_joint(model).normal, largest_chi * 5200 / 100);
  EXPECT_LT(springs_of_the_joint(model).normal, free);
}

TEST(JointStiffness, StaticStepsOfAnyLengthDoNot) {
  Model model = stack(automatic());
  const double chosen = springs_of_the_joint(model).normal;
  Stage still;
  still.integrator = static_integrator();
  still.dt = 1e3;
  model.stages.insert(model.stages.begin(), still);
  EXPECT_EQ(springs_of_the_joint(model).normal, chosen);
}

}  // namespace
}  // namespace dda
