// What stretches carried is carried on: forces and moments before and after, for contacts by lot along a face.
#include "engine/contact/lost_ends.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "engine/contact/interface_element.h"
#include "engine/geometry/rotation.h"

namespace dda {
namespace {

Interface contact_at(const Vec2& place, const Vec2& normal) {
  Interface interface;
  interface.block_a = 1;
  interface.block_b = 2;
  interface.from = interface.to = place;
  interface.normal = normal;
  return interface;
}

StretchEnd end_at(const Vec2& place, const Vec2& along, double press, double shear) {
  StretchEnd end{1, 2, place, along, {-along.y(), along.x()}, {}};
  end.state.force << press, shear, 0, 0;
  return end;
}

struct Sum {
  Vec2 force = Vec2::Zero();  // normal, shear
  double moment = 0;          // of the normal force about the start of the face

  void add(const Vec4& force_at, double position) {
    force += force_at.head<2>();
    moment += position * force_at(0);
  }
};

// Contacts at both ends of the face and at some places within it, up to three in one place; stretches end at any
// places.
TEST(LostEnds, ForcesAndMomentsAreThoseBefore) {
  std::mt19937 random(7);
  const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  for (int scene = 0; scene < 300; ++scene) {
    const Vec2 start(number(-5, 5), number(-5, 5));
    const double turn = number(-std::numbers::pi, std::numbers::pi);
    const Vec2 along = rotation(turn) * Vec2(1, 0);
    std::vector<double> places{0, number(2, 3)};
    for (int i = 0; i < 3; ++i) places.push_back(number(0.1, 1.9));
    std::vector<Interface> heirs;
    std::vector<double> positions;
    for (const double place : places)
      for (int i = number(0, 3) < 1 ? 2 : 1; i > 0; --i) {
        heirs.push_back(contact_at(start + place * along, {-along.y(), along.x()}));
        positions.push_back(place);
      }
    LostEnds ends;
    Sum before, after;
    for (int i = 0; i < 6; ++i) {
      const double place = i < 4 ? places[static_cast<std::size_t>(i)] : number(0, 2);
      const StretchEnd end = end_at(start + place * along, along, number(-3, 0), number(-1, 1));
      before.add(end.state.force, place);
      ends.add(end);
    }
    const auto states = ends.shared_among(heirs, 1e-9);
    for (std::size_t i = 0; i < heirs.size(); ++i)
      if (states[i]) after.add(states[i]->force, positions[i]);
    constexpr double round_off = 1e-13;  // of six forces of up to 3 at up to 3
    EXPECT_NEAR((after.force - before.force).norm(), 0, round_off) << scene;
    EXPECT_NEAR(after.moment, before.moment, 10 * round_off) << scene;
  }
}

TEST(LostEnds, AreOfOneFaceAndOnePair) {
  LostEnds ends;
  ends.add(end_at({1, 0}, {1, 0}, -2, 0));
  Interface other_pair = contact_at({1, 0}, {0, 1});
  other_pair.block_b = 3;
  const Interface other_face = contact_at({1, 0}, {1, 0}), far_face = contact_at({0, 1}, {0, 1});
  const auto states = ends.shared_among({other_pair, other_face, far_face, contact_at({3, 0}, {0, 1})}, 1e-9);
  EXPECT_FALSE(states[0]);
  EXPECT_FALSE(states[1]);
  EXPECT_FALSE(states[2]);
  ASSERT_TRUE(states[3]);
  EXPECT_EQ(states[3]->force(0), -2);
  // The same contact told from its other side.
  Interface turned = contact_at({1, 0}, {0, -1});
  std::swap(turned.block_a, turned.block_b);
  EXPECT_TRUE(ends.shared_among({turned}, 1e-9)[0]);
}

// Where a joint bends by two degrees both of its faces look the way of an end.
TEST(LostEnds, ForcesStayWithTheFaceThatTheyWereOf) {
  const Vec2 corner(1, 2), along(1, 0), bent = rotation(0.04) * along;
  const std::vector<Interface> heirs{contact_at(corner, {0, 1}), contact_at(corner, {-bent.y(), bent.x()})};
  LostEnds ends;
  ends.add(end_at(corner, along, -3, 1));
  ends.add(end_at(corner, bent, -5, 2));
  const auto left = ends.shared_among(heirs, 1e-9);
  ASSERT_TRUE(left[0] && left[1]);
  EXPECT_LT((left[0]->force - Vec4(-3, 1, 0, 0)).norm(), 1e-14);
  EXPECT_LT((left[1]->force - Vec4(-5, 2, 0, 0)).norm(), 1e-14);
}

// Only one of the two faces may have a contact there. Rock under stress that nobody touched was set in motion by forces
// that had turned with the face.
TEST(LostEnds, ForcesKeepTheirDirectionOnAnotherFace) {
  const Vec2 corner(1, 2), along(1, 0), bent = rotation(0.04) * along;
  for (const double sense : {1.0, -1.0}) {
    Interface heir = contact_at(corner, {0, sense});
    if (sense < 0) std::swap(heir.block_a, heir.block_b);
    LostEnds ends;
    ends.add(end_at(corner, bent, -5, 2));
    const auto left = ends.shared_among({heir}, 1e-9);
    ASSERT_TRUE(left[0]);
    const Vec2 before = local_axes({-bent.y(), bent.x()}).transpose() * Vec2(-5, 2);
    const Vec2 after = sense * (local_axes(heir.normal).transpose() * left[0]->force.head<2>());
    EXPECT_LT((after - before).norm(), 1e-14);
  }
}

}  // namespace
}  // namespace dda
