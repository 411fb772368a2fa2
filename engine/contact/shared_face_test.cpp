// Faces with vertices within them: what their contacts stand for, and when their joints go over to contacts.
#include "engine/contact/shared_face.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "engine/contact/contact_models.h"
#include "engine/contact/make_contacts.h"
#include "engine/contact/moving_contacts.h"
#include "engine/geometry/rotation.h"

namespace dda {
namespace {

JointMaterial joint_with(double cohesion) {
  JointMaterial joint;
  joint.law = InterfaceLaw::classical;
  joint.friction_angle = 0.5;
  joint.cohesion = joint.tensile_strength = cohesion;
  return joint;
}

// No vertex contacts are looked for between blocks that a joint holds: what is broken of their stretches stays too.
TEST(SharedFace, StretchesBetweenTwoBlocksEndTogether) {
  Model model = model_of({{{{0, 0}, {4, 0}, {4, 1}, {2, 1}, {0, 1}}, {}}, {box_ring(1, 1, 3, 2), {}}});
  model.joints = {joint_with(1e6)};
  ContactSet contacts = make_contacts(model);
  const State state = initial_state(model);
  MovingContacts moving(model, state, contacts);
  ASSERT_EQ(contacts.interfaces.size(), 2U);
  contacts.states[0].broken = {true, true};
  contacts.states[1].broken = {true, false};
  moving.follow(model, state, contacts);
  ASSERT_EQ(contacts.interfaces.size(), 2U);
  EXPECT_GT(contacts.interfaces[0].length, 0);
  contacts.states[1].broken = {true, true};
  moving.follow(model, state, contacts);
  ASSERT_EQ(contacts.interfaces.size(), 3U);
  for (const Interface& interface : contacts.interfaces) EXPECT_EQ(interface.length, 0);
}

// The shares of a face add up to its length, wherever vertices of the other block lie along it: within, at or near its
// ends.
TEST(SharedFace, SharesOfAFaceAddUpToItsLength) {
  for (const std::vector<double>& places :
       {std::vector<double>{}, {2.0}, {1.0}, {3.0}, {1.0, 3.0}, {1.3, 2.0, 2.9}, {0.5, 1.0, 2.5, 3.0, 3.5}})
    for (const double angle : {0.0, 0.3, -1.1}) {
      Ring ground{{0, 0}, {4, 0}, {4, 1}};
      for (auto place = places.rbegin(); place != places.rend(); ++place) ground.emplace_back(*place, 1);
      ground.emplace_back(0, 1);
      Ring box = box_ring(1, 1, 3, 2);
      for (Ring* ring : {&ground, &box})
        for (Vec2& vertex : *ring) vertex = rotation(angle) * vertex;
      Model model = model_of({{ground, {}}, {box, {}}});
      model.joints = {joint_with(0)};
      model.joints[0].residual_cohesion = 1;
      ContactSet contacts = make_contacts(model);
      const MovingContacts moving(model, initial_state(model), contacts);
      double sum = 0;
      for (const EndStrength& strength : contacts.strengths) sum += strength.residual_cohesion;
      EXPECT_NEAR(sum, 2, 1e-12) << places.size() << " vertices, turned by " << angle;
    }
}

// A wall leans back from the corner of a box on the floor: the corner touches it, and nothing of the box's face does.
TEST(SharedFace, CornersAtAFaceThatLeansHaveNoCohesion) {
  for (const double lean : {0.0, 0.02, 0.2, 0.7}) {
    const Ring notch{{-3, -1}, {6, -1}, {6, 2}, {2 + 2 * std::tan(lean), 2}, {2, 0}, {-3, 0}};
    Model model = model_of({{notch, {}}, {box_ring(0, 0, 2, 1), {}}});
    model.joints = {joint_with(0)};
    model.joints[0].residual_cohesion = 1;
    ContactSet contacts = make_contacts(model);
    const MovingContacts moving(model, initial_state(model), contacts);
    double floor = 0, wall = 0;
    for (std::size_t i = 0; i < contacts.interfaces.size(); ++i)
      (contacts.interfaces[i].normal(1) > 0.99 ? floor : wall) += contacts.strengths[i].residual_cohesion;
    EXPECT_NEAR(floor, 2, 1e-12) << lean;
    if (lean > 0.1) {
      EXPECT_EQ(wall, 0) << lean;
    } else {
      EXPECT_GT(wall, 0.4) << lean;
    }
  }
}

}  // namespace
}  // namespace dda
