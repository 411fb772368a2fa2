#include "engine/advice/joint_remarks.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "engine/contact/contact_models.h"
#include "engine/contact/make_contacts.h"

namespace dda {
namespace {

// Two bricks on each other, as drawn throughout.
std::vector<std::string> remarks_on(JointMaterial joint) {
  Model model = model_of({{box_ring(0, 0, 2, 1), {}}, {box_ring(0, 1, 2, 2), {}}});
  joint.name = "j";
  joint.friction_angle = 0.6;
  model.joints = {joint};
  model.stages.resize(1);
  model.stages[0].dt = model.stages[0].duration = 1;
  model.stages[0].kinematics = Kinematics::small;
  finish_model(model);
  return joint_remarks(model, make_contacts(model));
}

TEST(JointRemarks, SayThatSpringsOfJointsThatPassStressOnActLater) {
  JointMaterial joint;
  joint.law = InterfaceLaw::consistent;
  EXPECT_TRUE(remarks_on(joint).empty());
  joint.normal_spring = 1e10;
  ASSERT_EQ(remarks_on(joint).size(), 1);
  EXPECT_NE(remarks_on(joint)[0].find("its springs act where it has slipped or opened, and not before"),
            std::string::npos);
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::projected}) {
    joint.law = law;
    EXPECT_TRUE(remarks_on(joint).empty());
  }
}

// They are for when it has broken.
TEST(JointRemarks, SayNothingOfSpringsOfJointsThatBreak) {
  JointMaterial joint;
  joint.law = InterfaceLaw::consistent;
  joint.spring_over_young = 30;
  joint.cohesion = joint.residual_cohesion = 1e6;
  EXPECT_TRUE(remarks_on(joint).empty());
}

// 20 GPa/m without its unit.
TEST(JointRemarks, SayThatAStiffnessIsThatOfNoJoint) {
  JointMaterial joint;
  joint.law = InterfaceLaw::classical;
  joint.normal_stiffness = 20;
  ASSERT_EQ(remarks_on(joint).size(), 1);
  EXPECT_EQ(remarks_on(joint)[0], "joint \"j\": normal_stiffness is 20 Pa/m; joints of rock have 1e8 to 1e12 Pa/m");
  joint.normal_stiffness = 20e9;
  EXPECT_TRUE(remarks_on(joint).empty());
}

}  // namespace
}  // namespace dda
