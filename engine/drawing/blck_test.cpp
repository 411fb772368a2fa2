// Blocks as dc of the original DDA writes them. The files are written by hand in the layout of dc, with six decimals.
#include "engine/cutting/given_blocks.h"
#include "engine/drawing/drawing_test_support.h"
#include "engine/drawing/read_formats.h"

namespace dda {
namespace {

// A floor, and on it two stones side by side whose joint ends on the edge of the floor. Behind the vertices of each
// block stand its first once more and what dc keeps of its area. Point kinds in front of points, as DDA for Windows.
const std::string stones =
    "3 0 24 \n1 1 1 \n1 1 4 \n2 9 12 \n2 17 20 \n"
    "1.000000 0.000000 0.000000\n1.000000 6.000000 0.000000\n2.000000 6.000000 2.000000\n1.000000 0.000000 1.000000\n"
    "1.000000 0.000000 0.000000\n0.000000 9.000000 0.000000\n0.000000 28.000000 13.000000\n0.000000 0.000000 0.000000\n"
    "2.000000 0.000000 1.000000\n3.000000 2.000000 1.333333\n1.000000 2.000000 3.000000\n1.000000 0.000000 3.000000\n"
    "2.000000 0.000000 1.000000\n0.000000 3.666667 0.000000\n0.000000 3.500000 7.500000\n0.000000 0.000000 0.000000\n"
    "2.000000 2.000000 1.333333\n1.000000 6.000000 2.000000\n1.000000 6.000000 3.000000\n3.000000 2.000000 3.000000\n"
    "2.000000 2.000000 1.333333\n0.000000 5.333333 0.000000\n0.000000 20.888889 12.0\n0.000000 0.000000 0.000000\n"
    "0.000000 3.000000 0.500000 1.000000 \n2.000000 1.000000 2.900000 2.000000 \n1.000000 0.000000 3.000000 2.000000 "
    "\n";

std::string with(const std::string& text, const std::string& old, const std::string& by) {
  std::string changed = text;
  return changed.replace(changed.find(old), old.size(), by);
}

// In the other way of writing points: x, y and block.
std::string without_kinds(const std::string& text) {
  const std::string rest = text.substr(0, text.find("0.000000 3.000000 0.500000 1"));
  return rest + "3.0 0.5 1\n1.0 2.9 2\n0.0 3.0 2\n";
}

TEST(ReadBlck, BlocksHaveMaterialsJointsAndPoints) {
  for (const std::string& text : {stones, without_kinds(stones)}) {
    const LineDrawing drawing = read_blck(text, "stones.blck", 0);
    const RockPlan plan = plan_of(drawing, {});
    ASSERT_EQ(plan.blocks.size(), 3U);
    EXPECT_EQ(plan.blocks[0].material, "material 1");
    EXPECT_EQ(plan.blocks[2].material, "material 2");
    ASSERT_EQ(plan.points.size(), 3U);
    EXPECT_EQ(plan.points[0].layer, "fix point");
    EXPECT_EQ(plan.points[0].at, Vec2(3, 0.5));
    EXPECT_EQ(plan.points[1].layer, "load point");
    EXPECT_EQ(plan.points[2].layer, "measure point");
    EXPECT_EQ(locate(plan.blocks[1].shape, plan.points[2].at), Location::inside);  // drawn on its corner
    EXPECT_LT((plan.points[2].at - Vec2(0, 3)).norm(), 1e-4);
  }
}

// The corner at (2, 1.333333) lies 3e-7 m below the edge from (6, 2) to (0, 1) that it is on.
TEST(ReadBlck, RoundedCornersAreOnTheEdgesThatTheyWereCutFrom) {
  const CutRock rock = given_rock(plan_of(read_blck(stones, "a.blck", 0), {}), 0);
  ASSERT_EQ(rock.blocks.size(), 3U);
  EXPECT_TRUE(rock.cleaned.empty());  // edges without neighbours are no joints, and nothing to report
  double area = 0;
  for (const CutBlock& block : rock.blocks) {
    area += area_moments(block.shape).area;
    for (const Vec2& corner : block.shape.outer) {
      if (std::abs(corner.x() - 2) < 0.1 && corner.y() < 2) {
        EXPECT_NEAR(corner.y(), 1 + corner.x() / 6, 1e-15);
      }
    }
  }
  EXPECT_NEAR(area, 9 + 11.0 / 3 + 16.0 / 3, 1e-6);  // the six decimals of the file
  std::vector<std::string> joints;
  for (const CutJoint& joint : rock.joints) joints.push_back(joint.joint);
  std::ranges::sort(joints);
  joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
  EXPECT_EQ(joints, (std::vector<std::string>{"joint 2", "joint 3"}));
}

TEST(ReadBlck, BlocksWithoutMaterialHaveTheFirst) {
  const std::string square = "1 0 8\n0 0 0\n0 1 4\n1 0 0\n1 1 0\n1 1 1\n1 0 1\n1 0 0\n0 1 0\n0 0.5 0.5\n0 0 0\n";
  EXPECT_EQ(plan_of(read_blck(square, "a.blck", 0), {}).blocks.front().material, "material 1");
  EXPECT_EQ(plan_of(read_blck(square, "a.blck", 0.5), {}).blocks.front().shape.outer[2], Vec2(0.5, 0.5));
}

TEST(ReadBlck, WhatIsWrongIsSaidInOneSentence) {
  const std::string square =
      "1 0 8\n1 0 0\n1 1 4\n1 0 0\n1 1 0\n1 1 1\n1 0 1\n1 0 0\n0 1 0\n0 0.5 0.5\n0 0 0\n0.5 0 1\n";
  const std::vector<std::pair<std::string, std::string>> all{
      {"", "a.blck line 1 is the end of the file, before the number of blocks"},
      {with(square, "1 0 8", "0 0 8"), "a.blck line 1 is 0 for the number of blocks, expected a whole number from 1"},
      {with(square, "1 0 8", "1 2 8"), "a.blck line 1 is 2 bolts, expected none: give bolts in the scene"},
      {with(square, "1 1 4\n1 0", "1 1 9\n1 0"),
       "a.blck line 3 is a block of the vertices 1 to 9, expected three or more"},
      {with(square, "1 1 4\n1 0", "1 1 3\n1 0"),
       "a.blck line 7 is at (0, 1) m, expected the first vertex of the block once more"},
      {with(square, "1 1 0\n", "1.5 1 0\n"),
       "a.blck line 5 is 1.5 for the joint material of an edge, expected a whole"},
      {with(square, "0.5 0 1", "0.5 0 2"),
       "a.blck line 12 is 2 for the block of a point, expected a whole number from 1 to 1"},
      {square + "7 8\n", "is 5 numbers of 1 points, expected three or four of each"},
      {with(square, "1 1 0\n", "1 x 0\n"), "a.blck line 5 is \"x\" for the x of a vertex, expected a finite number"},
  };
  for (const auto& each : all) expect_refused([&] { read_blck(each.first, "a.blck", 0); }, each.second);
}

}  // namespace
}  // namespace dda
