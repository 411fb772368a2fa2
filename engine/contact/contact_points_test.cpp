#include "engine/contact/contact_points.h"

#include <gtest/gtest.h>

#include "engine/contact/contact_models.h"
#include "engine/contact/contact_set.h"
#include "engine/contact/make_contacts.h"

namespace dda {
namespace {

constexpr double round_off = 1e-12;  // relative; a dozen products

// Two blocks above each other, turned by `angle`; a is the one below.
struct Pair {
  explicit Pair(InterfaceLaw law, double angle) {
    model = model_of({{box_ring(0, 0, 2, 1), {}}, {box_ring(0, 1, 2, 2), {}}});
    model.joints[0].law = law;
    model.joints[0].bonded = true;
    place(model, angle, Vec2(5, -3));
    state = initial_state(model);
    contacts = make_contacts(model);
  }

  [[nodiscard]] std::vector<ContactPoint> points() const {
    std::vector<ContactPoint> found;
    append_contact_points(model, state, contacts.interfaces[0], contacts.elements[0], contacts.states[0], found);
    return found;
  }

  Model model;
  State state;
  ContactSet contacts;
};

// Minus the internal force of the interface on block b: total force and moment about its centroid.
Vec3 force_and_moment_on_b(const Pair& pair) {
  const Vec6 internal = pair.contacts.elements[0].rows_b.transpose() * pair.contacts.states[0].force;
  return -internal.head<3>();
}

Vec3 force_and_moment_of(const std::vector<ContactPoint>& points, const Vec2& centroid) {
  Vec3 sum = Vec3::Zero();
  for (const ContactPoint& point : points) {
    const Vec2 arm = point.point - centroid;
    const Vec2 force = point.force();
    sum += Vec3(force.x(), force.y(), arm.x() * force.y() - arm.y() * force.x());
  }
  return sum;
}

TEST(ContactPoints, CarryTheForceAndTheMomentOfTheInterface) {
  for (const InterfaceLaw law : {InterfaceLaw::classical, InterfaceLaw::consistent}) {
    for (const double angle : {0.0, 0.7, -2.0}) {
      Pair pair(law, angle);
      pair.contacts.states[0].force << -3e5, 4e4, 2e5, -1e4;
      const auto points = pair.points();
      ASSERT_EQ(points.size(), 2U);
      const Vec3 expected = force_and_moment_on_b(pair);
      const Vec3 found = force_and_moment_of(points, pair.model.blocks[1].moments.centroid);
      EXPECT_LE((found - expected).norm(), round_off * expected.norm()) << angle;
    }
  }
}

// The page of a run leaves out what is open, and with it lost a part of the force.
TEST(ContactPoints, OfAStretchThatGapesPressAtOnePlace) {
  for (const double angle : {0.0, 0.7, -2.0})
    for (const std::size_t gaping : {0U, 1U}) {
      Pair pair(InterfaceLaw::projected, angle);
      InterfaceState& state = pair.contacts.states[0];
      state.force << -3e5, 4e4, 1e5, -1e4;
      if (gaping == 0) state.force << 1e5, -1e4, -3e5, 4e4;
      state.status[gaping] = ContactStatus::open;
      state.status[1 - gaping] = ContactStatus::locked;
      const auto points = pair.points();
      ASSERT_EQ(points.size(), 2U);
      EXPECT_EQ(points[gaping].force().norm(), 0);
      const Vec3 expected = force_and_moment_on_b(pair);
      const Vec3 found = force_and_moment_of(points, pair.model.blocks[1].moments.centroid);
      EXPECT_LE((found - expected).norm(), round_off * expected.norm()) << angle;
    }
}

// The reconstruction's normal force is not that of row 0, but mean_traction gives it; its moment is that of row 3.
TEST(ContactPoints, OfTheCubicLawCarryItsMeanTractionAndMoment) {
  Pair pair(InterfaceLaw::cubic, 0.3);
  ASSERT_EQ(pair.contacts.elements[0].law, InterfaceLaw::cubic);
  pair.contacts.states[0].force << -3e5, 4e4, 2e5, -1e4;
  pair.contacts.states[0].gap << 1e-5, 0, 0, 0;
  const auto points = pair.points();
  ASSERT_EQ(points.size(), 2U);
  const Vec2 traction =
      mean_traction(pair.model, pair.contacts.interfaces[0], pair.contacts.elements[0], pair.contacts.states[0]);
  EXPECT_NEAR(points[0].normal_force + points[1].normal_force, 2 * traction(0), round_off * 3e5);  // 2 m long
  EXPECT_NEAR(points[0].shear_force + points[1].shear_force, 2 * traction(1), round_off * 3e5);
  EXPECT_NEAR(points[1].normal_force - points[0].normal_force, -1e4, round_off * 3e5);
}

TEST(ContactPoints, CompressionPushesTheBlocksApart) {
  Pair pair(InterfaceLaw::classical, 0);
  pair.contacts.states[0].force << -1, 0, -2, 0;
  Vec2 sum = Vec2::Zero();
  for (const ContactPoint& point : pair.points()) {
    EXPECT_EQ(point.block_b, 1);
    EXPECT_LT(point.normal_force, 0);
    sum += point.force();
  }
  EXPECT_LE((sum - Vec2(0, 3)).norm(), round_off);  // the upper block is pushed up
}

TEST(ContactPoints, MoveWithTheirBlock) {
  Pair pair(InterfaceLaw::classical, 0);
  pair.state.displacement[1].head<2>() << 0.25, 0.5;
  pair.contacts.states[0].status = {ContactStatus::sliding, ContactStatus::open};
  const auto points = pair.points();
  for (const ContactPoint& point : points)
    EXPECT_LE((point.point - point.reference - Vec2(0.25, 0.5)).norm(), round_off);
  EXPECT_NE(points[0].reference, points[1].reference);
  EXPECT_EQ(points[0].status, ContactStatus::sliding);
  EXPECT_EQ(points[1].status, ContactStatus::open);
}

TEST(ContactPoints, AVertexOnAnEdgeIsOnePoint) {
  const Model model = model_of({{box_ring(0, 0, 2, 1), {}}, {{{1, 1}, {2, 2}, {0, 2}}, {}}});
  const ContactSet contacts = make_contacts(model);
  ASSERT_EQ(contacts.interfaces.size(), 1U);
  std::vector<ContactPoint> points;
  append_contact_points(model, initial_state(model), contacts.interfaces[0], contacts.elements[0], contacts.states[0],
                        points);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points[0].point, Vec2(1, 1));
}

}  // namespace
}  // namespace dda
