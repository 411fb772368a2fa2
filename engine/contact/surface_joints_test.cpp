#include "engine/contact/surface_joints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/contact/contact_models.h"
#include "engine/contact/contact_search.h"
#include "engine/contact/contact_set.h"

namespace dda {
namespace {

JointMaterial joint_called(const std::string& name) {
  JointMaterial joint;
  joint.name = name;
  return joint;
}

// Joints 0 (default), 1, 2, and 3, which is bonded.
void give_joints(Model& model, const std::vector<JointLine>& lines) {
  model.joints = {joint_called("default"), joint_called("one"), joint_called("two"), joint_called("bond")};
  model.joints.back().bonded = true;
  model.joint_lines = lines;
  finish_model(model);
}

// Two by two squares of 1 m, numbered row by row from below.
Model squares() {
  return model_of(
      {{box_ring(0, 0, 1, 1), {}}, {box_ring(1, 0, 2, 1), {}}, {box_ring(0, 1, 1, 2), {}}, {box_ring(1, 1, 2, 2), {}}});
}

std::vector<int> joints_of(const Model& model) {
  std::vector<int> joints;
  for (const Interface& interface : find_interfaces(model)) joints.push_back(interface.joint);
  return joints;
}

// Interfaces are those of blocks 0-1, 0-2, 1-3 and 2-3.
TEST(SurfaceJoints, StretchesOnALineHaveItsJoint) {
  Model model = squares();
  give_joints(model, {{{0, 1}, {2, 1}, 1}});
  EXPECT_EQ(joints_of(model), (std::vector{0, 1, 1, 0}));
  give_joints(model, {{{2, 1}, {0, 1}, 1}});
  EXPECT_EQ(joints_of(model), (std::vector{0, 1, 1, 0})) << "either way round";
  give_joints(model, {{{0, 1}, {2, 1}, 1}, {{0, 1}, {1, 1}, 2}});
  EXPECT_EQ(joints_of(model), (std::vector{0, 2, 1, 0})) << "a later line goes before an earlier one";
  give_joints(model, {{{0.3, 1}, {1.3, 1}, 1}});
  EXPECT_EQ(joints_of(model), (std::vector{0, 1, 0, 0})) << "more than half of a stretch";
  give_joints(model, {{{0, 0.999}, {2, 0.999}, 1}, {{0, 0}, {2, 2}, 2}});
  EXPECT_EQ(joints_of(model), (std::vector{0, 0, 0, 0})) << "beside the joint, and across it";
}

TEST(SurfaceJoints, LinesGoBeforePairs) {
  Model model = squares();
  model.joint_of_block_pair = {{{0, 1}, 2}, {{0, 2}, 2}};
  give_joints(model, {{{0, 1}, {2, 1}, 1}});
  EXPECT_EQ(joints_of(model), (std::vector{2, 1, 1, 0}));
}

TEST(SurfaceJoints, ALoneVertexOnALineHasItsJoint) {
  Model model = model_of({{box_ring(0, -1, 3, 0), {}}, {{{1.5, 0}, {2, 1}, {1, 1}}, {}}});
  give_joints(model, {{{0, 0}, {3, 0}, 1}});
  EXPECT_EQ(joints_of(model), (std::vector{1}));
  give_joints(model, {{{0, 0}, {1.4, 0}, 1}});
  EXPECT_EQ(joints_of(model), (std::vector{0}));
}

// Two cells beside each other, and one above them whose corner reaches down to the ground between them: the faces
// between cells are bonded, the ground is another block. A corner that had the joint of these faces glued them to it.
TEST(SurfaceJoints, ALineThatEndsAtAnEdgeHasNoCornerOnIt) {
  Model model = model_of({{box_ring(0, -1, 4, 0), {}},
                          {{{0, 0}, {2, 0}, {0, 2}}, {}},
                          {{{2, 0}, {4, 0}, {4, 2}}, {}},
                          {{{2, 0}, {4, 2}, {0, 2}}, {}}});
  const std::vector<JointLine> between_cells = {{{2, 0}, {0, 2}, 1}, {{4, 2}, {2, 0}, 1}};
  give_joints(model, between_cells);
  EXPECT_EQ(joints_of(model), (std::vector{0, 0, 0, 1, 1})) << "ground-left, ground-right, ground-corner, the cells";
  std::vector<JointLine> under_half = between_cells;
  under_half.insert(under_half.begin(), {{0, 0}, {2, 0}, 2});
  give_joints(model, under_half);
  EXPECT_EQ(joints_of(model), (std::vector{2, 0, 2, 1, 1})) << "a line along the ground that ends at the corner";
}

// A line for each face, as rock of cells has: each face looks at the few lines beside it, and not at all 3,120.
TEST(SurfaceJoints, StretchesLookAtTheLinesBesideThem) {
  constexpr int side = 40;
  std::vector<Polygon> blocks;
  std::vector<JointLine> lines;
  for (int row = 0; row < side; ++row) {
    for (int i = 0; i < side; ++i) {
      blocks.push_back({box_ring(i, row, i + 1, row + 1), {}});
      const Vec2 corner(i, row);
      if (i > 0) lines.push_back({corner, corner + Vec2(0, 1), 1 + (i + row) % 2});
      if (row > 0) lines.push_back({corner, corner + Vec2(1, 0), 1 + (i + row) % 2});
    }
  }
  Model model = model_of(blocks);
  give_joints(model, lines);
  const JointLines joints(model);
  for (const Interface& interface : find_interfaces(model)) {
    const Vec2 start = interface.from.cwiseMin(interface.to);
    EXPECT_EQ(interface.joint, 1 + static_cast<int>(std::lround(start.x() + start.y())) % 2);
    EXPECT_LE(joints.near({interface.from, interface.to}).size(), 7U);
  }
}

// Joints of the contacts on the box, of those that carry on the floor, once the box is at `x`.
class OnAFloor : public testing::Test {
 protected:
  std::vector<int> joints_at(double x, const std::vector<JointLine>& lines) {
    Model model = model_of({{box_ring(0, -1, 9, 0), {}}, {box_ring(0, 0, 1, 1), {}}});
    model.joint_of_block_pair = {{{0, 1}, 2}};
    give_joints(model, lines);
    State state = initial_state(model);
    const SurfaceJoints joints(model, make_outlines(model, state));
    state.displacement[1](0) += x;
    const ContactSearch search(model, state);
    std::vector<int> found;
    for (const VertexContact& contact : search.find({}))
      if (std::abs(contact.normal.y()) > 0.5) found.push_back(joints.joint_of(model, search.outlines(), contact));
    return found;
  }
};

TEST_F(OnAFloor, ABlockTakesTheJointOfItsSurfaceWithIt) {
  const std::vector<JointLine> under_the_box = {{{0, 0}, {1, 0}, 1}};
  EXPECT_EQ(joints_at(0, under_the_box), (std::vector{1, 1}));
  EXPECT_EQ(joints_at(5, under_the_box), (std::vector{1, 1}));
  EXPECT_EQ(joints_at(8.5, under_the_box), (std::vector{1, 1})) << "the floor's corner under the box";
}

TEST_F(OnAFloor, TheFloorKeepsItsOwn) {
  const std::vector<JointLine> right_of_it = {{{3, 0}, {9, 0}, 1}};
  EXPECT_EQ(joints_at(0, right_of_it), (std::vector{2, 2})) << "that of the pair";
  EXPECT_EQ(joints_at(5, right_of_it), (std::vector{1, 1}));
  EXPECT_EQ(joints_at(2.5, right_of_it), (std::vector{2, 1})) << "half on it";
}

TEST_F(OnAFloor, BondedLinesSayNothingOfOtherSurfaces) {
  const std::vector<JointLine> under_the_box = {{{0, 0}, {1, 0}, 3}};
  EXPECT_EQ(joints_at(5, under_the_box), (std::vector{2, 2})) << "rock that was bonded to other rock";
  const std::vector<JointLine> both = {{{0, 0}, {1, 0}, 3}, {{3, 0}, {9, 0}, 1}};
  EXPECT_EQ(joints_at(5, both), (std::vector{1, 1})) << "on a joint";
  EXPECT_EQ(joints_at(0, under_the_box), (std::vector{3, 3})) << "on the rock that it is bonded to";
}

TEST_F(OnAFloor, WhereSurfacesDifferThePairDecides) {
  const std::vector<JointLine> both = {{{0, 0}, {1, 0}, 1}, {{3, 0}, {9, 0}, 0}};
  EXPECT_EQ(joints_at(0, both), (std::vector{1, 1}));
  EXPECT_EQ(joints_at(1.5, both), (std::vector{1, 1}));
  EXPECT_EQ(joints_at(5, both), (std::vector{2, 2}));
}

}  // namespace
}  // namespace dda
