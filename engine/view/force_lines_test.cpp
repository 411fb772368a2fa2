#include "engine/view/force_lines.h"

#include <gtest/gtest.h>

#include "engine/geometry/segment.h"

namespace dda {
namespace {

constexpr double round_off = 1e-13;

// Squares of 2 m in a column, block 0 at the foot.
Drawing column(int blocks) {
  Drawing drawing;
  drawing.ring_begin = {0};
  drawing.block_begin = {0};
  for (int i = 0; i < blocks; ++i) {
    for (const Vec2& corner : {Vec2(0, 0), Vec2(2, 0), Vec2(2, 2), Vec2(0, 2)})
      drawing.reference.push_back(corner + Vec2(0, 2 * i));
    drawing.ring_begin.push_back(static_cast<std::uint32_t>(drawing.reference.size()));
    drawing.block_begin.push_back(static_cast<std::uint32_t>(drawing.rings()));
  }
  return drawing;
}

DrawnContact contact(int a, int b, const Vec2& reference, const Vec2& force) {
  return {a, b, reference, Vec2(0, 0), force, false, DrawnStatus::locked};
}

double distance_from_line(const ForceLine& line, const Vec2& point) {
  return std::abs(cross((line.to - line.from).normalized(), point - line.from));
}

TEST(ForceLines, AreaAndCentroidLeaveHolesOut) {
  Drawing drawing = column(1);
  for (const Vec2& corner : {Vec2(1, 1), Vec2(1, 2), Vec2(2, 2), Vec2(2, 1)}) drawing.reference.push_back(corner);
  drawing.ring_begin.push_back(8);
  drawing.block_begin = {0, 2};
  const auto [area, centroid] = area_and_centroid(drawing, drawing.reference, 0);
  EXPECT_NEAR(area, 3, round_off);                                   // 4 - 1
  EXPECT_LE((centroid - Vec2(5.0 / 6, 5.0 / 6)).norm(), round_off);  // (4 * 1 - 1.5)/3
}

TEST(ForceLines, OfAContactIsCentredOnItAlongItsForce) {
  const Drawing drawing = column(2);
  DrawnContact one = contact(0, 1, Vec2(2, 2), Vec2(3, 4));
  one.displacement = Vec2(0.5, 0);
  const auto lines = contact_lines(drawing, {one}, 10);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].force, 5);
  EXPECT_LE(((lines[0].from + lines[0].to) / 2 - Vec2(7, 2)).norm(), round_off);
  EXPECT_NEAR(cross(lines[0].to - lines[0].from, Vec2(3, 4)), 0, round_off * 10);
  one.status = DrawnStatus::open;
  EXPECT_TRUE(contact_lines(drawing, {one}, 1).empty());
}

// Two parallel forces: the resultant lies at their weighted mean, whichever block the contacts belong to.
TEST(ForceLines, OfAJointIsItsResultantOnItsLineOfAction) {
  const Drawing drawing = column(2);
  for (const bool exchanged : {false, true}) {
    std::vector<DrawnContact> contacts = {contact(0, 1, Vec2(0, 2), Vec2(0, 30)),
                                          contact(0, 1, Vec2(2, 2), Vec2(0, 10))};
    if (exchanged) contacts[1] = contact(1, 0, Vec2(2, 2), Vec2(0, -10));
    const auto lines = joint_lines(drawing, drawing.reference, contacts, 1);
    ASSERT_EQ(lines.size(), 2U);  // one in either block
    for (const ForceLine& line : lines) {
      EXPECT_EQ(line.force, 40);
      EXPECT_LE((line.from - Vec2(0.5, 2)).norm(), round_off);
      EXPECT_NEAR(line.to.x(), 0.5, round_off);
    }
    EXPECT_NEAR(lines[0].to.y(), 1, round_off);  // to the height of the centroids
    EXPECT_NEAR(lines[1].to.y(), 3, round_off);
  }
}

TEST(ForceLines, ResultantOfSlopingForcesHasTheirMoment) {
  const Drawing drawing = column(2);
  const std::vector<DrawnContact> contacts = {contact(0, 1, Vec2(0.2, 2), Vec2(1, 7)),
                                              contact(0, 1, Vec2(1.7, 2), Vec2(-3, 4))};
  const Vec2 force(-2, 11);
  const double moment = cross(Vec2(0.2, 2), Vec2(1, 7)) + cross(Vec2(1.7, 2), Vec2(-3, 4));
  for (const ForceLine& line : joint_lines(drawing, drawing.reference, contacts, 1)) {
    EXPECT_NEAR(cross(line.from, force), moment, round_off * 100);
    EXPECT_NEAR(distance_from_line(line, line.from + force), 0, round_off * 100);
  }
}

TEST(ForceLines, ThrustGoesFromJointToJoint) {
  const Drawing drawing = column(3);
  const std::vector<DrawnContact> contacts = {contact(0, 1, Vec2(0.4, 2), Vec2(1, 20)),
                                              contact(1, 2, Vec2(1.6, 4), Vec2(1, 19))};
  const auto lines = joint_lines(drawing, drawing.reference, contacts, 1);
  int meeting = 0;
  for (const ForceLine& line : lines) meeting += (line.to - Vec2(1, 3)).norm() < round_off ? 1 : 0;
  EXPECT_EQ(meeting, 2);
}

// Two stones on one that a support bears: no thrust from stone to stone.
TEST(ForceLines, ForcesToTheSameSideDoNotMeet) {
  const Drawing drawing = column(3);
  for (const bool exchanged : {false, true}) {
    const DrawnContact left =
        exchanged ? contact(1, 0, Vec2(0.4, 2), Vec2(0, 20)) : contact(0, 1, Vec2(0.4, 2), Vec2(0, -20));
    const auto lines = joint_lines(drawing, drawing.reference, {left, contact(1, 2, Vec2(1.6, 4), Vec2(0, 20))}, 1);
    ASSERT_EQ(lines.size(), 4U);
    for (const ForceLine& line : lines) EXPECT_NEAR(line.to.x(), line.from.x(), round_off);
  }
}

TEST(ForceLines, SmallForcesAreNotDrawnAndTensionIsMarked) {
  const Drawing drawing = column(3);
  DrawnContact pulled = contact(1, 2, Vec2(1, 4), Vec2(0, -1000));
  pulled.tension = true;
  const auto lines = joint_lines(drawing, drawing.reference, {contact(0, 1, Vec2(1, 2), Vec2(0, 9)), pulled}, 1);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_TRUE(lines[0].tension);
}

}  // namespace
}  // namespace dda
