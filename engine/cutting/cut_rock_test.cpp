#include "engine/cutting/cut_rock.h"

#include <gtest/gtest.h>

#include <numbers>

#include "engine/core/error.h"
#include "engine/cutting/cutting_test_support.h"
#include "engine/cutting/opening_shapes.h"

namespace dda {
namespace {

TEST(CutRock, WithoutLinesTheRockIsOneBlock) {
  const RockPlan plan = square_plan();
  const CutRock rock = cut_rock(plan);
  ASSERT_EQ(rock.blocks.size(), 1U);
  EXPECT_EQ(rock.blocks[0].shape.outer, plan.boundary);
  EXPECT_TRUE(rock.joints.empty());
  EXPECT_TRUE(rock.cleaned.empty());
}

TEST(CutRock, TwoCrossingLinesMakeFourBlocks) {
  RockPlan plan = square_plan();
  add_line(plan, {{0, 3}, {10, 3}}, "level");
  add_line(plan, {{6, 0}, {6, 10}}, "upright");
  const CutRock rock = cut_rock(plan);
  expect_sound(rock, plan);
  EXPECT_EQ(rock.blocks.size(), 4U);
  ASSERT_EQ(rock.joints.size(), 2U);
  EXPECT_EQ(rock.joints[0].joint, "level");
  EXPECT_TRUE(rock.cleaned.empty());
}

TEST(CutRock, ATJunctionKeepsItsJoint) {
  RockPlan plan = square_plan();
  add_line(plan, {{0, 4}, {10, 4.7}});
  add_line(plan, {{4, 0}, {4, 4.28}});          // ends on the first, to round-off
  add_line(plan, {{7, 10}, {7, 4.49 + 1e-6}});  // falls short of it by a tenth of the tolerance
  add_line(plan, {{2, 10}, {2, 4.14 - 1e-6}});  // sticks out by as much
  const CutRock rock = cut_rock(plan);
  expect_sound(rock, plan);
  EXPECT_EQ(rock.blocks.size(), 5U);
  EXPECT_EQ(count(rock, Cleaning::end_prolonged), 1);
  EXPECT_EQ(count(rock, Cleaning::dangle_trimmed), 1);
}

TEST(CutRock, EndsThatFallShortByMoreThanTheToleranceAreTrimmed) {
  RockPlan plan = square_plan();
  add_line(plan, {{0, 4}, {10, 4}});
  add_line(plan, {{7, 10}, {7, 4.001}});
  const CutRock rock = cut_rock(plan);
  EXPECT_EQ(rock.blocks.size(), 2U);
  ASSERT_EQ(rock.dangles_trimmed, 1);
  const auto trimmed = std::find_if(rock.cleaned.begin(), rock.cleaned.end(),
                                    [](const Cleaned& c) { return c.what == Cleaning::dangle_trimmed; });
  EXPECT_NEAR(trimmed->size, 5.999, 1e-12);
  EXPECT_EQ(trimmed->origin, "line 2");
  CutOptions wide;
  wide.tolerance = 0.002;
  EXPECT_EQ(cut_rock(plan, wide).blocks.size(), 3U);
}

TEST(CutRock, DoubledLinesCutOnce) {
  RockPlan plan = square_plan();
  add_line(plan, {{0, 4}, {10, 6}}, "first");
  add_line(plan, {{10, 6}, {0, 4}}, "second");
  add_line(plan, {{5, 5}, {10, 6}}, "third");
  const CutRock rock = cut_rock(plan);
  expect_sound(rock, plan);
  EXPECT_EQ(rock.blocks.size(), 2U);
  EXPECT_EQ(count(rock, Cleaning::lines_overlap), 2);
  ASSERT_EQ(rock.joints.size(), 2U);
  EXPECT_EQ(rock.joints[0].joint, "second");
  EXPECT_EQ(rock.joints[1].joint, "third");
}

TEST(CutRock, AJointCountsBeforeAConstructionLineAlongIt) {
  RockPlan plan = square_plan();
  add_line(plan, {{0, 4}, {10, 4}}, "joint");
  add_line(plan, {{0, 4}, {10, 4}}, "glue");
  plan.lines[1].construction = true;
  const CutRock rock = cut_rock(plan);
  ASSERT_EQ(rock.joints.size(), 1U);
  EXPECT_EQ(rock.joints[0].joint, "joint");
}

TEST(CutRock, ALineWithoutLengthIsReported) {
  RockPlan plan = square_plan();
  add_line(plan, {{4, 4}, {4, 4}});
  const CutRock rock = cut_rock(plan);
  EXPECT_EQ(rock.blocks.size(), 1U);
  EXPECT_EQ(count(rock, Cleaning::line_without_length), 1);
}

TEST(CutRock, LinesAlongTheBoundaryCutNothing) {
  RockPlan plan = square_plan();
  add_line(plan, {{0, 0}, {10, 0}});
  add_line(plan, {{-5, 10}, {15, 10}});
  add_line(plan, {{20, 0}, {20, 10}});
  const CutRock rock = cut_rock(plan);
  expect_sound(rock, plan);
  EXPECT_EQ(rock.blocks.size(), 1U);
  EXPECT_EQ(rock.blocks[0].shape.outer, plan.boundary);
  EXPECT_EQ(count(rock, Cleaning::line_not_used), 3);
}

TEST(CutRock, ThreeLinesThroughNearlyOnePointMakeSixBlocks) {
  RockPlan plan = square_plan();
  add_line(plan, {{0, 0}, {10, 10}});
  add_line(plan, {{0, 10}, {10, 0}});
  add_line(plan, {{5 + 2e-6, 0}, {5 + 2e-6, 10}});  // the triangle between them is narrower than the tolerance
  const CutRock rock = cut_rock(plan);
  expect_sound(rock, plan);
  EXPECT_EQ(rock.blocks.size(), 6U);
  EXPECT_EQ(count(rock, Cleaning::sliver_merged), 1);
  EXPECT_GE(count(rock, Cleaning::short_edge_closed), 1);
}

TEST(CutRock, NearDuplicatesMakeNoSlivers) {
  RockPlan plan = square_plan();
  add_line(plan, {{0, 4}, {10, 4}});
  add_line(plan, {{0, 4 + 5e-6}, {10, 4 + 5e-6}});
  add_line(plan, {{0, 4 - 3e-6}, {10, 4 + 3e-6}});
  const CutRock rock = cut_rock(plan);
  expect_sound(rock, plan);
  EXPECT_EQ(rock.blocks.size(), 2U);
  EXPECT_GE(rock.merged, 2);
}

TEST(CutRock, ATunnelTangentToJoints) {
  RockPlan plan = square_plan();
  plan.openings.push_back({"tunnel", circle({5, 5}, 2, 0.01), "", false, "openings[0]"});
  add_line(plan, {{0, 7}, {10, 7}});
  add_line(plan, {{7, 0}, {7, 10}});
  const CutRock rock = cut_rock(plan);
  expect_sound(rock, plan);
  EXPECT_EQ(std::count_if(rock.blocks.begin(), rock.blocks.end(), [](const CutBlock& b) { return b.opening == 0; }), 1);
  EXPECT_EQ(rock.blocks.size(), 6U);  // the quarter with the tunnel falls into two between the points of contact
}

TEST(CutRock, AnOpeningInsideABlockLeavesAHole) {
  RockPlan plan = square_plan();
  plan.openings.push_back({"shaft", rectangle({5, 4}, 2, 2), "", true, "openings[0]"});
  plan.holes.push_back({{1, 1}, {2, 1}, {2, 2}, {1, 2}});
  const CutRock rock = cut_rock(plan);
  ASSERT_EQ(rock.blocks.size(), 1U);
  EXPECT_EQ(rock.blocks[0].shape.holes.size(), 2U);
  EXPECT_NEAR(total_area(rock), 100 - 4 - 1, 1e-12);
  EXPECT_NEAR(rock.left_out_area, 4, 1e-12);
  EXPECT_NEAR(rock.boundary_area, 99, 1e-12);
}

TEST(CutRock, ALoopWithinABlockIsABlockOfItsOwn) {
  RockPlan plan = square_plan();
  add_line(plan, {{3, 3}, {6, 3}, {6, 6}, {3, 6}, {3, 3}});
  add_line(plan, {{6, 5}, {9, 5}});  // leads from the loop to nowhere
  const CutRock rock = cut_rock(plan);
  expect_sound(rock, plan);
  EXPECT_EQ(rock.blocks.size(), 2U);
  EXPECT_EQ(rock.dangles_trimmed, 1);
}

// Two triangles on either side of a crossing, hung to nothing but each other.
TEST(CutRock, OutlinesThatTouchThemselvesAreParted) {
  RockPlan plan = square_plan();
  add_line(plan, {{3, 3}, {7, 7}});
  add_line(plan, {{3, 7}, {7, 3}});
  add_line(plan, {{3.5, 2}, {3.5, 8}});
  add_line(plan, {{6.5, 2}, {6.5, 8}});
  const CutRock rock = cut_rock(plan);
  expect_sound(rock, plan);
  EXPECT_EQ(rock.blocks.size(), 3U);
  EXPECT_EQ(count(rock, Cleaning::touching_parted), 1);
}

TEST(CutRock, ABlockThatHangsAtTheBoundaryWithOneCorner) {
  RockPlan plan = square_plan();
  add_line(plan, {{5, 0}, {4, 4}, {6, 4}, {5, 0}});
  const CutRock rock = cut_rock(plan);
  expect_sound(rock, plan);
  EXPECT_EQ(rock.blocks.size(), 2U);
  EXPECT_EQ(count(rock, Cleaning::touching_parted), 1);
}

TEST(CutRock, SmallAndSharpBlocksGoToNeighboursWhenAsked) {
  RockPlan plan = square_plan();
  add_line(plan, {{0, 0.05}, {10, 0.05}});
  add_line(plan, {{0, 10}, {10, 9}});
  EXPECT_EQ(cut_rock(plan).blocks.size(), 3U);
  CutOptions options;
  options.least_area = 1;
  const CutRock without_small = cut_rock(plan, options);
  expect_sound(without_small, plan);
  EXPECT_EQ(without_small.blocks.size(), 2U);
  EXPECT_EQ(count(without_small, Cleaning::small_block_merged), 1);
  options.least_area = 0;
  options.least_angle = 10 * std::numbers::pi / 180;
  const CutRock without_sharp = cut_rock(plan, options);
  EXPECT_EQ(without_sharp.blocks.size(), 2U);
  EXPECT_EQ(count(without_sharp, Cleaning::sharp_block_merged), 1);
}

TEST(CutRock, RegionsGiveMaterials) {
  RockPlan plan = square_plan();
  plan.material = "granite";
  add_line(plan, {{0, 5}, {10, 5}});
  plan.regions.push_back({{{-1, -1}, {11, -1}, {11, 5}, {-1, 5}}, "clay", "regions[0]"});
  const CutRock rock = cut_rock(plan);
  ASSERT_EQ(rock.blocks.size(), 2U);
  EXPECT_EQ(rock.blocks[0].material, "clay");
  EXPECT_EQ(rock.blocks[1].material, "granite");
  EXPECT_TRUE(rock.remarks.empty());
}

// An inclusion that is smaller than the blocks, or drawn beside them, would be left out without a word.
TEST(CutRock, RegionsWithoutBlocksAreRemarkedOn) {
  RockPlan plan = square_plan();
  plan.regions.push_back({{{1, 1}, {2, 1}, {2, 2}, {1, 2}}, "ore", "regions[0]"});
  plan.regions.push_back({{{20, 1}, {22, 1}, {22, 2}, {20, 2}}, "clay", "regions[1]"});
  const std::vector<std::string> remarks = cut_rock(plan).remarks;
  ASSERT_EQ(remarks.size(), 2U);
  EXPECT_EQ(remarks[0].find("regions[0] has the middle of no block in it, so it gives \"ore\" to none"), 0U)
      << remarks[0];
  EXPECT_EQ(remarks[1].find("regions[1] "), 0U) << remarks[1];
}

void expect_refusal(const RockPlan& plan, const std::string& sentence, const CutOptions& options = {}) {
  try {
    cut_rock(plan, options);
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(sentence), std::string::npos) << error.what();
  }
}

// The box of a square that is turned by 45 degrees has 1.41 times its diagonal. What lies between two joints that are
// as far apart as 1.2 tolerances is a block, however the plan is turned.
TEST(CutRock, TheToleranceStaysWhereAPlanIsTurned) {
  constexpr double tolerance = 1e-6 * 10 * std::numbers::sqrt2;
  for (const double angle : {0.0, 0.3, std::numbers::pi / 4, 1.1, 2.0}) {
    const auto turned = [&](double x, double y) {
      return Vec2(std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y);
    };
    RockPlan plan = square_plan();
    for (Vec2& corner : plan.boundary) corner = turned(corner.x(), corner.y());
    for (const double height : {4.0, 4.0 + 1.2 * tolerance}) add_line(plan, {turned(-1, height), turned(11, height)});
    const CutRock rock = cut_rock(plan);
    EXPECT_NEAR(rock.tolerance, tolerance, 1e-12 * tolerance) << angle;
    EXPECT_EQ(rock.blocks.size(), 3U) << angle;
  }
}

TEST(CutRock, RefusesWhatCannotBeCut) {
  RockPlan crossed = square_plan();
  crossed.boundary = {{0, 0}, {10, 10}, {10, 0}, {0, 10}};
  expect_refusal(crossed, "boundary is self-intersecting");
  RockPlan outside = square_plan();
  outside.openings.push_back({"tunnel", circle({50, 5}, 2, 0.01), "", false, "openings[0]"});
  expect_refusal(outside, "openings[0] is \"tunnel\" around (50, 5) m, outside the rock");
  RockPlan many = square_plan();
  for (int i = 1; i < 10; ++i) add_line(many, {{0, double(i)}, {10, double(i)}});
  CutOptions options;
  options.most_blocks = 5;
  expect_refusal(many, "cut into 10 blocks, expected at most 5", options);
}

// Two lines as far apart as round-off become one in the first round; were there no more rounds, whether that was all
// would not be known.
TEST(CutRock, RoundsOfClosingRoundOffThatAreUsedUpAreRemarkedOn) {
  RockPlan plan = square_plan();
  add_line(plan, {{0, 3}, {10, 3}});
  add_line(plan, {{0, 3 + 1e-9}, {10, 3}});
  EXPECT_TRUE(cut_rock(plan).remarks.empty());
  CutOptions options;
  options.most_rounds = 1;
  const CutRock rock = cut_rock(plan, options);
  expect_sound(rock, plan);
  ASSERT_EQ(rock.remarks.size(), 1U);
  EXPECT_EQ(rock.remarks[0].find("corners and lines nearer to each other than 1.41e-07 m may be left"), 0U)
      << rock.remarks[0];
}

}  // namespace
}  // namespace dda
