#include "engine/contact/moving_contacts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/contact/contact_models.h"
#include "engine/contact/make_contacts.h"

namespace dda {
namespace {

JointMaterial joint_of(double cohesion) {
  JointMaterial joint;
  joint.law = InterfaceLaw::classical;
  joint.friction_angle = 0.5;
  joint.cohesion = joint.tensile_strength = cohesion;
  return joint;
}

// A box on a wider one, away from its corners, or on one just as wide.
struct Scene {
  explicit Scene(double floor_width, double cohesion = 0)
      : model(model_of(
            {{box_ring((1 - floor_width) / 2, 0, (1 + floor_width) / 2, 1), {}}, {box_ring(0, 1, 1, 2), {}}})) {
    model.joints = {joint_of(cohesion)};
    contacts = make_contacts(model);
    state = initial_state(model);
  }

  // With the gaps of vertex contacts that a step finds.
  void move_upper(double x, double y) {
    state.displacement[1].head<2>() += Vec2(x, y);
    for (std::size_t i = 0; i < contacts.states.size(); ++i) {
      if (contacts.interfaces[i].length > 0) continue;
      const double sense = contacts.interfaces[i].block_b == 1 ? 1 : -1;
      contacts.states[i].gap(0) += sense * contacts.interfaces[i].normal.dot(Vec2(x, y));
    }
  }

  Model model;
  State state;
  ContactSet contacts;
};

// As a step that presses, shears and slides would leave it.
void load(ContactSet& contacts, double shear_gap, double slip) {
  for (std::size_t i = 0; i < contacts.states.size(); ++i) {
    InterfaceState& state = contacts.states[i];
    state.status[0] = ContactStatus::sliding;
    state.gap(1) = shear_gap * static_cast<double>(i + 1);
    state.slip[0] = slip * static_cast<double>(i + 1);
    state.force.head<2>() = contacts.elements[i].stiffness.head<2>().cwiseProduct(state.gap.head<2>());
  }
}

TEST(MovingContacts, DryStretchesBecomeVertexContacts) {
  Scene scene(3);
  ASSERT_EQ(scene.contacts.interfaces.size(), 1U);
  const MovingContacts moving(scene.model, scene.state, scene.contacts);
  ASSERT_EQ(scene.contacts.interfaces.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(scene.contacts.elements[i].length, 0);
    EXPECT_TRUE(scene.contacts.states[i].broken[0]);
    EXPECT_NEAR(scene.contacts.strengths[i].friction, std::tan(0.5), 1e-15);
    EXPECT_EQ(scene.contacts.strengths[i].cohesion, 0);
  }
}

TEST(MovingContacts, KnownContactsKeepShearAndSlipAndMeasureTheirGap) {
  Scene scene(3);
  MovingContacts moving(scene.model, scene.state, scene.contacts);
  load(scene.contacts, 1e-6, 1e-4);
  scene.move_upper(0.5, -1e-5);
  moving.follow(scene.model, scene.state, scene.contacts);
  ASSERT_EQ(scene.contacts.states.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const InterfaceState& state = scene.contacts.states[i];
    const Vec4& stiffness = scene.contacts.elements[i].stiffness;
    const double number = static_cast<double>(i + 1);
    EXPECT_EQ(state.status[0], ContactStatus::sliding);
    EXPECT_EQ(state.gap(1), 1e-6 * number);
    EXPECT_EQ(state.slip[0], 1e-4 * number);
    EXPECT_NEAR(state.gap(0), -1e-5, 1e-15);
    EXPECT_NEAR(state.force(0), -1e-5 * stiffness(0), 1e-15 * stiffness(0));
    EXPECT_NEAR(state.force(1), 1e-6 * number * stiffness(1), 1e-18 * stiffness(1));
  }
}

TEST(MovingContacts, ContactsThatOpenForgetTheirShear) {
  Scene scene(3);
  MovingContacts moving(scene.model, scene.state, scene.contacts);
  load(scene.contacts, 1e-6, 1e-4);
  scene.move_upper(0, 1e-3);
  moving.follow(scene.model, scene.state, scene.contacts);
  for (const InterfaceState& state : scene.contacts.states) {
    EXPECT_EQ(state.status[0], ContactStatus::open);
    EXPECT_TRUE(state.force.isZero(0));
    EXPECT_EQ(state.gap(1), 0);
  }
  scene.move_upper(0, 1);
  moving.follow(scene.model, scene.state, scene.contacts);
  EXPECT_TRUE(scene.contacts.states.empty());
}

// Springs that in-situ stress has pressed: they carry it where blocks lie, let go as these part, and when they meet
// again there is nothing left of it.
TEST(MovingContacts, InSituStressIsCarriedUntilTheContactOpens) {
  Scene scene(3);
  for (Block& block : scene.model.blocks) block.initial_stress = {-3e5, -1e6, 2e5};
  scene.contacts = make_contacts(scene.model);
  MovingContacts moving(scene.model, scene.state, scene.contacts);
  const auto expect_pressed = [&](double share) {
    ASSERT_EQ(scene.contacts.states.size(), 2U);
    for (const InterfaceState& state : scene.contacts.states) EXPECT_NEAR(state.force(0), -5e5 * share, 1e-9 * 5e5);
  };
  expect_pressed(1);
  for (const InterfaceState& state : scene.contacts.states) EXPECT_NEAR(std::abs(state.force(1)), 1e5, 1e-4);
  const double pressed_in = 5e5 / scene.contacts.elements[0].stiffness(0);
  scene.move_upper(0, 0.75 * pressed_in);
  moving.follow(scene.model, scene.state, scene.contacts);
  expect_pressed(0.25);
  scene.move_upper(0, 0.5 * pressed_in);
  moving.follow(scene.model, scene.state, scene.contacts);
  expect_pressed(0);
  scene.move_upper(0, -1.5 * pressed_in);
  moving.follow(scene.model, scene.state, scene.contacts);
  expect_pressed(0.25);  // the overlap alone
}

// Where two corners are above each other, it is the one's vertex on the other's edge or the other way round, whichever
// side either is off by: still the same contact.
TEST(MovingContacts, AlignedCornersKeepTheirHistory) {
  for (const double shift : {1e-9, 1e-5, -1e-9, -1e-5}) {
    Scene scene(1);
    MovingContacts moving(scene.model, scene.state, scene.contacts);
    scene.move_upper(-shift, -1e-6);
    moving.follow(scene.model, scene.state, scene.contacts);
    ASSERT_EQ(scene.contacts.states.size(), 2U);
    load(scene.contacts, 1e-7, 1e-4);
    for (InterfaceState& state : scene.contacts.states) state.slip[0] = 3e-4;
    const auto shear_on_upper = [&] {
      Eigen::VectorXd force = Eigen::VectorXd::Zero(12);
      for (InterfaceState& state : scene.contacts.states) {
        state.gap(1) = std::copysign(1e-7, state.gap(1));
        state.force(1) = std::copysign(scene.contacts.elements[0].stiffness(1) * 1e-7, state.force(1));
      }
      add_contact_force(scene.contacts, force);
      return force(6);
    };
    const double before = shear_on_upper();
    ASSERT_NE(before, 0);
    scene.move_upper(2 * shift, 0);
    moving.follow(scene.model, scene.state, scene.contacts);
    ASSERT_EQ(scene.contacts.states.size(), 2U);
    for (const InterfaceState& state : scene.contacts.states) {
      EXPECT_EQ(state.slip[0], 3e-4) << shift;
      EXPECT_EQ(state.gap(1), 1e-7) << shift;
    }
    EXPECT_NEAR(shear_on_upper(), before, 1e-9 * std::abs(before)) << shift;
  }
}

// Each end of a common face its own, where the upper box gets wider than the lower one and both ends exchange roles.
TEST(MovingContacts, AlignedCornersDoNotTakeTheHistoryOfTheOtherEnd) {
  for (const double strain : {1e-5, -1e-5}) {
    Scene scene(1);
    MovingContacts moving(scene.model, scene.state, scene.contacts);
    const auto stretch_upper = [&](double by) {
      scene.state.deformation[1](0, 0) = 1 + by;
      scene.move_upper(0, -1e-7);
      moving.follow(scene.model, scene.state, scene.contacts);
      ASSERT_EQ(scene.contacts.states.size(), 2U);
    };
    const auto slip_at = [&](std::size_t i) { return scene.contacts.interfaces[i].from.x() < 0.5 ? 1e-4 : 2e-4; };
    stretch_upper(-strain);
    const int vertex_block = scene.contacts.interfaces[0].block_b;
    for (std::size_t i = 0; i < 2; ++i) scene.contacts.states[i].slip[0] = slip_at(i);
    stretch_upper(strain);
    ASSERT_NE(scene.contacts.interfaces[0].block_b, vertex_block);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(scene.contacts.states[i].slip[0], slip_at(i)) << strain;
  }
}

// A vertex that slides over a joint in its path, from one edge to the next in line.
TEST(MovingContacts, HistoryGoesOnAlongTheNextEdgeInLine) {
  Model model = model_of({{{{0, 0}, {4, 0}, {4, 1}, {2, 1}, {0, 1}}, {}}, {box_ring(0.9, 1, 1.9, 2), {}}});
  model.joints = {joint_of(0)};
  ContactSet contacts = make_contacts(model);
  State state = initial_state(model);
  MovingContacts moving(model, state, contacts);
  ASSERT_EQ(contacts.states.size(), 2U);
  load(contacts, 1e-7, 0);
  for (InterfaceState& each : contacts.states) each.slip[0] = 3e-4;
  state.displacement[1](0) += 0.2;
  moving.follow(model, state, contacts);
  // The straight vertex between the edges has come under the box: a third contact, without history.
  ASSERT_EQ(contacts.states.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(contacts.states[i].slip[0], contacts.interfaces[i].block_b == 1 ? 3e-4 : 0);
}

TEST(MovingContacts, StretchesWithStrengthStayUntilBothEndsAreBroken) {
  Scene scene(3, 1e6);
  MovingContacts moving(scene.model, scene.state, scene.contacts);
  ASSERT_EQ(scene.contacts.interfaces.size(), 1U);
  EXPECT_GT(scene.contacts.interfaces[0].length, 0);
  scene.contacts.states[0].broken = {true, false};
  moving.follow(scene.model, scene.state, scene.contacts);
  ASSERT_EQ(scene.contacts.interfaces.size(), 1U);
  scene.contacts.states[0].broken = {true, true};
  moving.follow(scene.model, scene.state, scene.contacts);
  ASSERT_EQ(scene.contacts.interfaces.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(scene.contacts.elements[i].length, 0);
    EXPECT_EQ(scene.contacts.strengths[i].cohesion, 0);
    EXPECT_NEAR(scene.contacts.strengths[i].friction, std::tan(0.5), 1e-15);
  }
}

// What the ends of a broken stretch have become goes on in the vertex contacts that take their place.
TEST(MovingContacts, BrokenStretchesHandOverTheirHistory) {
  Scene scene(3, 1e6);
  MovingContacts moving(scene.model, scene.state, scene.contacts);
  InterfaceState& whole = scene.contacts.states.at(0);
  whole.broken = whole.residual = {true, true};
  whole.status = {ContactStatus::sliding, ContactStatus::locked};
  whole.gap << -1e-5, 1e-7, -2e-5, 2e-7;
  whole.force = scene.contacts.elements[0].stiffness.cwiseProduct(whole.gap);
  whole.slip = {1e-3, 2e-3};
  whole.dilation = {1e-5, 2e-5};
  const Vec2 from = scene.contacts.interfaces[0].from;
  moving.follow(scene.model, scene.state, scene.contacts);
  ASSERT_EQ(scene.contacts.states.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const double number = scene.contacts.interfaces[i].from == from ? 1 : 2;
    const InterfaceState& state = scene.contacts.states[i];
    EXPECT_EQ(state.gap(1), 1e-7 * number);
    EXPECT_EQ(state.slip[0], 1e-3 * number);
    EXPECT_EQ(state.dilation[0], 1e-5 * number);
    EXPECT_EQ(state.status[0], number == 1 ? ContactStatus::sliding : ContactStatus::locked);
    EXPECT_NEAR(state.gap(0), -1e-5 * number, 1e-15) << "what has ridden up is pressed in by as much";
    EXPECT_TRUE(state.residual[0]);
  }
}

TEST(MovingContacts, BrokenStretchesThatCarriedNothingBringNoForce) {
  Scene scene(3, 1e6);
  MovingContacts moving(scene.model, scene.state, scene.contacts);
  scene.contacts.states.at(0).broken = {true, true};
  scene.move_upper(0, -1e-3);
  moving.follow(scene.model, scene.state, scene.contacts);
  ASSERT_EQ(scene.contacts.states.size(), 2U);
  for (const InterfaceState& state : scene.contacts.states) EXPECT_EQ(state.force(0), 0);
}

// Surfaces of a joint that had a bond meet again elsewhere: nothing of the bond is there. Dry ones are as they were.
TEST(MovingContacts, ContactsOfAFailedJointAreResidual) {
  for (const double cohesion : {0.0, 1e6}) {
    Model model = model_of({{box_ring(0, 0, 3, 1), {}}, {box_ring(0, 1.1, 1, 2), {}}});
    model.joints = {joint_of(cohesion)};
    model.joints[0].residual_cohesion = cohesion / 10;
    ContactSet contacts = make_contacts(model);
    State state = initial_state(model);
    MovingContacts moving(model, state, contacts);
    state.displacement[1](1) = -0.1;
    moving.follow(model, state, contacts);
    ASSERT_EQ(contacts.states.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(contacts.states[i].residual[0], cohesion > 0);
      EXPECT_DOUBLE_EQ(contacts.strengths[i].residual_cohesion, cohesion / 10 / 2) << "half of a metre each";
    }
  }
}

// A tip, from one block of the floor to the next.
TEST(MovingContacts, HistoryGoesOnOverAJointOfTheFloor) {
  Model model =
      model_of({{box_ring(0, 0, 2, 1), {}}, {box_ring(2, 0, 4, 1), {}}, {{{1.9, 1}, {2.4, 2}, {1.4, 2}}, {}}});
  model.joints = {joint_of(0)};
  ContactSet contacts = make_contacts(model);
  State state = initial_state(model);
  state.displacement[2](1) = -1e-6;
  MovingContacts moving(model, state, contacts);
  const auto under_the_tip = [&] {
    std::size_t found = 0;
    while (contacts.interfaces.at(found).block_b != 2) ++found;
    return found;
  };
  contacts.states[under_the_tip()].slip[0] = 3e-4;
  contacts.states[under_the_tip()].gap(1) = 1e-7;
  ASSERT_EQ(contacts.interfaces[under_the_tip()].block_a, 0);
  state.displacement[2](0) = 0.2;
  moving.follow(model, state, contacts);
  ASSERT_EQ(contacts.interfaces[under_the_tip()].block_a, 1);
  EXPECT_EQ(contacts.states[under_the_tip()].slip[0], 3e-4);
  EXPECT_EQ(contacts.states[under_the_tip()].gap(1), 1e-7);
}

// Whatever the choice of contacts, the one that comes from nowhere does not press at once.
TEST(MovingContacts, AContactFromNowhereBringsNoForce) {
  Model model = model_of({{box_ring(0, 0, 3, 1), {}}, {box_ring(0.5, 1.1, 1.5, 2), {}}});
  model.joints = {joint_of(0)};
  ContactSet contacts = make_contacts(model);
  State state = initial_state(model);
  MovingContacts moving(model, state, contacts);
  const auto go_to_depth = [&](double depth) {
    const double motion = -0.1 - depth - state.displacement[1](1);
    state.displacement[1](1) += motion;
    for (InterfaceState& each : contacts.states) each.gap(0) += motion;  // as a step leaves it
    moving.follow(model, state, contacts);
    ASSERT_EQ(contacts.states.size(), 2U);
  };
  go_to_depth(1e-3);
  for (const InterfaceState& each : contacts.states) EXPECT_EQ(each.force(0), 0);
  go_to_depth(1.1e-3);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_NEAR(contacts.states[i].force(0), -1e-4 * contacts.elements[i].stiffness(0),
                1e-11 * contacts.elements[i].stiffness(0))
        << "of what came since";
  for (const double depth : {0.7e-3, 0.4e-3}) {
    go_to_depth(depth);
    for (const InterfaceState& each : contacts.states) EXPECT_EQ(each.force(0), 0) << "it does not push out";
  }
  go_to_depth(0.5e-3);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_NEAR(contacts.states[i].force(0), -1e-4 * contacts.elements[i].stiffness(0),
                1e-11 * contacts.elements[i].stiffness(0))
        << "closes where it has come out to";
  go_to_depth(-1e-3);
  go_to_depth(1e-4);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_NEAR(contacts.states[i].force(0), -1e-4 * contacts.elements[i].stiffness(0),
                1e-11 * contacts.elements[i].stiffness(0))
        << "all of it once it has been open";
}

// The next block of the floor stands higher by a ledge that the tip was not lifted over.
TEST(MovingContacts, AHandoverPressesNoMoreThanTheMotion) {
  constexpr double ledge = 4e-6;
  Model model =
      model_of({{box_ring(0, 0, 2, 1), {}}, {box_ring(2, 0, 4, 1), {}}, {{{1.9, 1}, {2.4, 2}, {1.4, 2}}, {}}});
  model.joints = {joint_of(0)};
  ContactSet contacts = make_contacts(model);
  State state = initial_state(model);
  state.displacement[1](1) = ledge;
  MovingContacts moving(model, state, contacts);
  const auto under_the_tip = [&] {
    std::size_t found = 0;
    while (contacts.interfaces.at(found).block_b != 2) ++found;
    return found;
  };
  state.displacement[2](1) = contacts.states[under_the_tip()].gap(0) = -1e-6;
  moving.follow(model, state, contacts);
  const double before = contacts.states[under_the_tip()].force(0);
  ASSERT_NEAR(before, -1e-6 * contacts.elements[under_the_tip()].stiffness(0), 1e-3);
  state.displacement[2](0) = 0.2;
  moving.follow(model, state, contacts);
  ASSERT_EQ(contacts.interfaces[under_the_tip()].block_a, 1);
  EXPECT_NEAR(contacts.states[under_the_tip()].force(0), before, 1e-3 * std::abs(before));
}

// Dilation may lift a block higher than contacts are looked for otherwise.
TEST(MovingContacts, ALiftedContactIsNotLost) {
  Scene scene(3);
  scene.model.joints[0].dilation_angle = 0.3;
  MovingContacts moving(scene.model, scene.state, scene.contacts);
  ASSERT_EQ(scene.contacts.states.size(), 2U);
  for (const double height : {0.015, 0.05, 0.3}) {
    for (InterfaceState& state : scene.contacts.states) {
      state.dilation[0] = height;
      state.gap(0) = -1e-5;
    }
    scene.state.displacement[1](1) = height - 1e-5;
    moving.follow(scene.model, scene.state, scene.contacts);
    ASSERT_EQ(scene.contacts.states.size(), 2U) << height;
    for (const InterfaceState& state : scene.contacts.states) {
      EXPECT_EQ(state.dilation[0], height);
      EXPECT_NEAR(state.gap(0), -1e-5, 1e-15);
    }
  }
}

}  // namespace
}  // namespace dda
