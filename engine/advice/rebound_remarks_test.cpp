#include "engine/advice/rebound_remarks.h"

#include <gtest/gtest.h>

#include "engine/contact/contact_models.h"
#include "engine/contact/make_contacts.h"

namespace dda {
namespace {

// A box thrown at a floor that is held.
Model thrown(const JointMaterial& joint) {
  Model model = model_of({{box_ring(-3, -1, 3, 0), {}}, {box_ring(0, 0.1, 1, 1.1), {}}});
  model.joints = {joint};
  model.joints[0].name = "j";
  model.held_blocks.resize(1);
  model.held_blocks[0].block = 0;
  model.blocks[1].initial_velocity = {0, -2};
  model.stages.resize(1);
  model.stages[0].dt = model.stages[0].duration = 1e-3;
  model.stages[0].kinematics = Kinematics::finite;
  model.stages[0].integrator = generalized_alpha_integrator(0);
  return model;
}

std::vector<std::string> remarks_on(Model model) {
  finish_model(model);
  return rebound_remarks(model, make_contacts(model));
}

JointMaterial with_springs(double over_young, double damping) {
  JointMaterial joint;
  joint.law = InterfaceLaw::classical;
  joint.spring_over_young = over_young;
  joint.contact_damping = damping;
  return joint;
}

TEST(ReboundRemarks, SayThatTheBlockIsTheSofterSpring) {
  ASSERT_EQ(remarks_on(thrown(with_springs(10, 1))).size(), 1);
  EXPECT_TRUE(remarks_on(thrown(with_springs(10, 1)))[0].starts_with(
      "joint \"j\": its contact_damping of 1 does not set how blocks rebound"));
  EXPECT_EQ(remarks_on(thrown(with_springs(1, 0.01))).size(), 1);
  JointMaterial joint = with_springs(10, 1);
  joint.law = InterfaceLaw::projected;
  EXPECT_EQ(remarks_on(thrown(joint)).size(), 1);
  joint.law = InterfaceLaw::consistent;
  EXPECT_EQ(remarks_on(thrown(joint)).size(), 1);
}

TEST(ReboundRemarks, SayItBySpringsInNewtonsPerMetre) {
  JointMaterial joint = with_springs(10, 1);
  const double young = thrown(joint).materials[0].young;
  joint.normal_spring = 0.1 * young;
  EXPECT_TRUE(remarks_on(thrown(joint)).empty());
  joint.normal_spring = young;
  EXPECT_EQ(remarks_on(thrown(joint)).size(), 1);
}

TEST(ReboundRemarks, SayNothingWhereDampingSetsIt) {
  EXPECT_TRUE(remarks_on(thrown(with_springs(0.1, 1))).empty());
  EXPECT_TRUE(remarks_on(thrown(with_springs(10, 0))).empty());
}

// Dashpots beside stiff springs have other uses, as against chatter.
TEST(ReboundRemarks, SayNothingWhereNothingFlies) {
  Model model = thrown(with_springs(10, 0.2));
  model.blocks[1].initial_velocity = {0, 0};
  EXPECT_TRUE(remarks_on(model).empty());
  model.gravity = {0, -10};
  EXPECT_EQ(remarks_on(model).size(), 1);
  model.blocks[1].shape.outer = box_ring(0, 0, 1, 1);
  EXPECT_TRUE(remarks_on(model).empty());
}

TEST(ReboundRemarks, SayNothingOfStaticStages) {
  Model model = thrown(with_springs(10, 1));
  model.stages[0].integrator = static_integrator();
  EXPECT_TRUE(remarks_on(model).empty());
}

}  // namespace
}  // namespace dda
