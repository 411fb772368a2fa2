// Files of dl and dc of the original DDA.
#include <fmt/format.h>

#include <random>

#include "engine/cutting/cut_rock.h"
#include "engine/drawing/drawing_test_support.h"
#include "engine/drawing/read_formats.h"
#include "engine/drawing/write_blocks.h"

namespace dda {
namespace {

// A square of 4 m with two joints that stick out; a fixed line along the bottom, a fixed point, a load point and
// a measured point.
const std::string quarters =
    "0.001\n6 0\n0\n0\n2\n1\n1\n0\n"
    "0 0 4 0 1\n4 0 4 4 1\n4 4 0 4 1\n0 4 0 0 1\n-0.5 2 4.5 2 2\n2 -0.5 2 4.5 3\n"
    "1 0.5 3 0.5\n1 3 1 3\n3.5 1\n0.5 0.5\n";

TEST(ReadDc, LinesEncloseTheRock) {
  const LineDrawing drawing = read_dc(quarters, "slope.dc", 0);
  EXPECT_EQ(drawing.lines.size(), 6U);
  DrawingOptions options;
  options.layers["joint 3"] = {LayerRole::rock, "bedding", false};
  const RockPlan plan = plan_of(drawing, options);
  EXPECT_EQ(signed_area(plan.boundary), 16);
  ASSERT_EQ(plan.lines.size(), 2U);  // those of the outline are gone
  EXPECT_EQ(plan.lines[0].joint, "");
  EXPECT_EQ(plan.lines[1].joint, "bedding");
  const CutRock rock = cut_rock(plan);
  EXPECT_EQ(rock.blocks.size(), 4U);
  for (const Cleaned& cleaned : rock.cleaned) EXPECT_EQ(cleaned.what, Cleaning::dangle_trimmed);
}

// The fixed line enters and leaves blocks at x = 2; a fixed point is its own.
TEST(ReadDc, FixedLinesHoldBlocksWhereTheyEnterThem) {
  const LineDrawing drawing = read_dc(quarters, "slope.dc", 0);
  std::vector<std::pair<std::string, Vec2>> found;
  for (const DrawnPoint& point : drawing.points) found.emplace_back(point.layer, point.at);
  EXPECT_EQ(
      found,
      (std::vector<std::pair<std::string, Vec2>>{
          {"fix point", {2, 0.5}}, {"fix point", {1, 3}}, {"load point", {3.5, 1}}, {"measure point", {0.5, 0.5}}}));
}

TEST(ReadDc, CoordinatesHaveTheUnitThatIsSaid) {
  const RockPlan plan = plan_of(read_dc(quarters, "slope.dc", 0.5), {});
  EXPECT_EQ(signed_area(plan.boundary), 4);
}

TEST(ReadDc, MaterialLinesArePassedOverAndCounted) {
  const LineDrawing drawing =
      read_dc("0\n3 0\n1\n0\n0\n0\n0\n0\n0 0 1 0 1\n1 0 0 1 1\n0 1 0 0 1\n0 0.2 1 0.2 5\n", "a.dc", 0);
  EXPECT_EQ(drawing.passed_over.at("material line"), 1);
}

std::string with(const std::string& text, const std::string& old, const std::string& by) {
  std::string changed = text;
  return changed.replace(changed.find(old), old.size(), by);
}

TEST(ReadDc, WhatIsWrongIsSaidInOneSentence) {
  const std::vector<std::pair<std::string, std::string>> all{
      {"", "a.dc line 1 is the end of the file, before the least distance"},
      {"<?xml version=\"1.0\"?>", "a.dc is XML, as later versions of DDA for Windows have it, expected the numbers"},
      {with(quarters, "0.001", "30"),
       "a.dc line 1 is 30 for the least distance of a node from an edge, expected a share"},
      {with(quarters, "6 0", "6.5 0"), "a.dc line 2 is 6.5 for the number of lines, expected a whole number"},
      {with(quarters, "6 0\n0\n0", "6 0\n0\n2"), "a.dc line 4 is 2 bolts, expected none: give bolts in the scene"},
      {with(quarters, "2\n1\n1\n0\n", "2\n1\n1\n1\n"), "a.dc line 19 is the end of the file, before hole point"},
      {with(quarters, "6 0", "7 0"), "expected"},
      {with(quarters, "6 0", "5 0"), "behind the last point"},
      {with(quarters, "4 4 1", "4 x 1"), "a.dc line 10 is \"x\" for the end of a line, expected a finite number"},
      {with(quarters, "4 4 1", "4 1e300 1"), "a.dc line 10 is at (4, 1e+300) m"},
      {quarters + "7\n", "a.dc line 19 is \"7\" behind the last point, expected as many numbers as the counts"},
  };
  for (const auto& each : all) expect_refused([&] { read_dc(each.first, "a.dc", 0); }, each.second);
}

TEST(ReadDc, LinesThatEncloseNoSinglePieceAreRefused) {
  const std::string head = "0\n6 0\n0\n0\n0\n0\n0\n0\n";
  const std::string triangle = "0 0 1 0 1\n1 0 0 1 1\n0 1 0 0 1\n";
  const auto plan = [&](const std::string& text) { return [text] { plan_of(read_dc(text, "a.dc", 0), {}); }; };
  expect_refused(plan("0\n1 0\n0\n0\n0\n0\n0\n0\n0 0 1 0 1\n"), "a.dc is a drawing whose lines enclose nothing");
  expect_refused(plan("0\n0 0\n0 0 0 0 0 0 0 0\n1 1\n1\n0 0 1 0\n0\n"),
                 "a.dc is a drawing whose lines enclose nothing");
  expect_refused(plan(head + triangle + "5 5 6 5 1\n6 5 5 6 1\n5 6 5 5 1\n"),
                 "a.dc is a drawing of 2 pieces of rock apart");
}

// As the MATLAB code of Appendix A of the thesis writes it: the square of 4 m with both joints and absorbing edges at
// the left and the right, which are lines as well; a fixed point, two load points, a measured point, a hole point and a
// point in a block to be removed. Numbers that are not whole have an exponent.
const std::string of_appendix =
    "1.000000e-03 \n6 0 \n0 0 1 2 1 1 0 1 \n"
    "0 0 4 0 1 \n4 0 4 4 1 \n4 4 0 4 1 \n0 4 0 0 1 \n-5.000000e-01 2 4.500000e+00 2 1 \n2 -1 2 5 1 \n"
    "1 1 1 \n1 \n3 1 \n1 3 \n5.000000e-01 1 \n3 3 \n3 1 \n1 1 \n2 \n4 0 4 4 \n0 4 0 0 \n0 \n";

TEST(ReadDc, FilesOfAppendixAAreWhatTheirTableIs) {
  const RockPlan plan = plan_of(read_dc(of_appendix, "a.dc", 0), {});
  const RockPlan of_table = plan_of(read_csv_drawing("layer,x1,y1,x2,y2,x,y\n"
                                                     "boundary,0,0,4,0,,\nboundary,4,4,0,4,,\n"
                                                     "absorbing boundary,4,0,4,4,,\nabsorbing boundary,0,4,0,0,,\n"
                                                     "rock,-0.5,2,4.5,2,,\nrock,2,-1,2,5,,\n"
                                                     "fix point,,,,,1,1\nload point,,,,,3,1\nload point,,,,,1,3\n"
                                                     "measure point,,,,,0.5,1\n",
                                                     "a.csv", 0),
                                    {});
  EXPECT_EQ(std::abs(signed_area(plan.boundary)), std::abs(signed_area(of_table.boundary)));
  ASSERT_EQ(plan.marks.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(plan.marks[i].points, of_table.marks[i].points);
    EXPECT_EQ(plan.marks[i].layer, of_table.marks[i].layer);
  }
  ASSERT_EQ(plan.points.size(), of_table.points.size() + 2);
  for (std::size_t i = 0; i < of_table.points.size(); ++i) {
    EXPECT_EQ(plan.points[i].at, of_table.points[i].at);
    EXPECT_EQ(plan.points[i].name, of_table.points[i].name);
  }
  EXPECT_EQ(cut_rock(of_table).blocks.size(), 4U);
}

// The block of the hole point is no rock; that of the other point is, until a stage removes it.
TEST(ReadDc, PointsInBlocksToBeRemovedNameTheseBlocks) {
  const RockPlan plan = plan_of(read_dc(of_appendix, "a.dc", 0), {});
  ASSERT_EQ(plan.openings.size(), 2U);
  const CutRock rock = cut_rock(plan);
  ASSERT_EQ(rock.blocks.size(), 3U);
  int removable = 0;
  for (const CutBlock& block : rock.blocks) {
    if (block.opening < 0) continue;
    ++removable;
    EXPECT_EQ(plan.openings[static_cast<std::size_t>(block.opening)].name, "removable hole 1");
    EXPECT_EQ(locate(block.shape, {3, 1}), Location::inside);
  }
  EXPECT_EQ(removable, 1);
}

TEST(ReadDc, WhatIsWrongInAppendixALayoutIsSaid) {
  const std::vector<std::pair<std::string, std::string>> all{
      {with(of_appendix, "1 1 \n2 \n", "1 2 \n2 \n"),
       "a.dc line 17 is 2 for the ratio by which the speed of waves is reduced"},
      {with(of_appendix, "0 0 1 2 1 1 0 1", "0 0 1 2 1 1 3 1"), "a.dc line 3 is 3 bolts, expected none"},
      {with(of_appendix, "0 4 0 0 \n0 \n", "0 4 0 0 \n5 \n"), "a.dc line 21 is 5 traction lines, expected none"},
  };
  for (const auto& each : all) expect_refused([&] { read_dc(each.first, "a.dc", 0); }, each.second);
  expect_refused([] { plan_of(read_dc(with(of_appendix, "0 4 0 0 \n0 \n", "1 4 1 0 \n0 \n"), "a.dc", 0), {}); },
                 "off the boundary, expected a line along the boundary");
}

// Nothing is left of the frame around the lines then, either.
TEST(ReadDc, RockSmallerThanWhatCountsAsOnePlaceIsRefused) {
  DrawingOptions options;
  options.reach = 100;
  expect_refused([&] { plan_of(read_dc(quarters, "a.dc", 0), options); },
                 "a.dc is smaller than 100 m, within which ends belong together, expected larger blocks, a tolerance");
  expect_refused([] { plan_of(read_dc(with(of_appendix, "4 0 4 4 \n0 4 0 0", "2e9 0 4 4 \n0 4 0 0"), "a.dc", 0), {}); },
                 "or no line far away from them");
}

// Four sides that are not quite upright, lines at random from side to side that stick out a little.
std::string random_lines(unsigned seed) {
  std::mt19937_64 random(seed);
  const auto lot = [&] { return 0.5 + 9 * static_cast<double>(random() >> 11U) * 0x1p-53; };
  constexpr double out = 1e-6;
  std::string text = "0.001\n14 0\n0\n0\n0\n0\n0\n0\n0 0 10 0.3 1\n10 0.3 10 10 1\n10 10 0.1 10 1\n0.1 10 0 0 1\n";
  for (int i = 0; i < 5; ++i) {
    const double left = lot();
    const double bottom = lot();
    text += fmt::format("{} {} {} {} 2\n", 0.01 * left - out, left, 10 + out, lot());
    text += fmt::format("{} {} {} {} 3\n", bottom, 0.03 * bottom - out, lot(), 10 + out);
  }
  return text;
}

// Blocks are sound and fill what the four sides enclose.
TEST(ReadDc, RandomLinesGiveSoundBlocks) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const RockPlan plan = plan_of(read_dc(random_lines(seed), "a.dc", 0), {});
    EXPECT_EQ(plan.boundary.size(), 4U);
    const CutRock rock = cut_rock(plan);
    EXPECT_GT(rock.blocks.size(), 10U);
    double area = 0;
    for (const CutBlock& block : rock.blocks) {
      EXPECT_FALSE(defect(block.shape).has_value());
      area += area_moments(block.shape).area;
    }
    EXPECT_NEAR(area + rock.dropped_area, std::abs(signed_area(plan.boundary)), 1e-10);
  }
}

std::string with_holes(const std::string& text, const std::vector<Vec2>& holes) {
  std::string changed = with(text, "0\n0\n0\n0\n0\n0\n0\n", fmt::format("0\n0\n0\n0\n0\n0\n{}\n", holes.size()));
  for (const Vec2& hole : holes) changed += fmt::format("{} {}\n", hole.x(), hole.y());
  return changed;
}

TEST(ReadDc, AHolePointTakesOutTheBlockAroundIt) {
  const std::string text = with(quarters, "2\n1\n1\n0\n", "2\n1\n1\n3\n") + "3 3\n2.5 2.5\n3 1\n";
  const RockPlan plan = plan_of(read_dc(text, "a.dc", 0), {});
  ASSERT_EQ(plan.openings.size(), 2U);  // two of the points lie in one block
  const CutRock rock = cut_rock(plan);
  EXPECT_EQ(rock.blocks.size(), 2U);
  EXPECT_EQ(rock.left_out_area, 8);
}

TEST(ReadDc, HolePointsInNoBlockAreRefused) {
  const std::string triangle = "0\n3 0\n0\n0\n0\n0\n0\n0\n0 0 1 0 1\n1 0 0 1 1\n0 1 0 0 1\n";
  const auto plan = [&](const Vec2& hole) {
    return [=] { plan_of(read_dc(with_holes(triangle, {hole}), "a.dc", 0), {}); };
  };
  expect_refused(plan({5, 5}), "a.dc line 12 (layer hole point) is at (5, 5) m, in no block, expected a place inside");
  expect_refused(plan({0.5, 0}), "a.dc line 12 (layer hole point) is at (0.5, 0) m, in no block");
}

// The others stay what they are: as many, of the same areas at the same places.
TEST(ReadDc, HolePointsInRandomLinesLeaveTheOtherBlocks) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::vector<CutBlock> expected = cut_rock(plan_of(read_dc(random_lines(seed), "a.dc", 0), {})).blocks;
    std::vector<Vec2> holes;
    for (int i = 0; i < 4; ++i) {
      const Vec2 hole = area_moments(expected[random() % expected.size()].shape).centroid;
      holes.push_back(hole);
      std::erase_if(expected, [&](const CutBlock& block) { return locate(block.shape, hole) == Location::inside; });
    }
    const CutRock rock = cut_rock(plan_of(read_dc(with_holes(random_lines(seed), holes), "a.dc", 0), {}));
    ASSERT_EQ(rock.blocks.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const AreaMoments moments = area_moments(expected[i].shape);
      const auto found = std::ranges::find_if(rock.blocks, [&](const CutBlock& block) {
        return locate(block.shape, moments.centroid) == Location::inside;
      });
      ASSERT_NE(found, rock.blocks.end());
      EXPECT_FALSE(defect(found->shape).has_value());
      EXPECT_NEAR(area_moments(found->shape).area, moments.area, 1e-9);
    }
  }
}

std::string dc_of(const CutRock& rock) {
  BlockDrawing drawing;
  for (const CutBlock& block : rock.blocks) drawing.blocks.push_back({"rock", "rock", block.shape, ""});
  for (const CutJoint& run : rock.joints) drawing.joints.push_back({run.joint, run.from, run.to});
  return block_file("a.dc", drawing);
}

// What is written is cut into the same blocks.
void expect_back_from_dc(const CutRock& rock) {
  const CutRock again = cut_rock(plan_of(read_dc(dc_of(rock), "a.dc", 0), {}));
  ASSERT_EQ(again.blocks.size(), rock.blocks.size());
  for (std::size_t i = 0; i < rock.blocks.size(); ++i) {
    const AreaMoments a = area_moments(rock.blocks[i].shape);
    const AreaMoments b = area_moments(again.blocks[i].shape);
    EXPECT_NEAR(a.area, b.area, 1e-12);
    EXPECT_LT((a.centroid - b.centroid).norm(), 1e-12);
  }
}

TEST(WriteBlocks, DcIsReadBack) {
  RockPlan plan;
  plan.boundary = {{0, 0}, {7, 0}, {7, 5}, {3, 6.1}, {0, 5}};
  plan.boundary_origin = "boundary";
  plan.lines.push_back({{{-1, 1}, {8, 2.3}}, "bedding", "lines[0]", false});
  plan.lines.push_back({{{2, -1}, {3.3, 7}}, "cross", "lines[1]", false});
  plan.lines.push_back({{{3, 7}, {6, -1}}, "bedding", "lines[2]", false});
  expect_back_from_dc(cut_rock(plan));
}

// Two gaps inside that meet in a corner, and one at the edge of the rock.
TEST(WriteBlocks, DcLeavesOutWhatWasLeftOut) {
  RockPlan plan;
  plan.boundary = {{0, 0}, {6, 0}, {6, 5}, {0, 5}};
  plan.boundary_origin = "boundary";
  plan.lines.push_back({{{-1, 1.3}, {7, 2.3}}, "bedding", "lines[0]", false});
  plan.lines.push_back({{{1, -1}, {1.7, 7}}, "cross", "lines[1]", false});
  plan.openings.push_back({"a", {{2, 1}, {3, 1}, {3, 2}, {2, 2}}, "", true, "a"});
  plan.openings.push_back({"b", {{3, 2}, {4, 2}, {4, 3}, {3.5, 2.5}}, "", true, "b"});
  plan.openings.push_back({"c", {{5, 0}, {5.5, 0}, {5.5, 1}, {5, 1}}, "", true, "c"});
  const CutRock rock = cut_rock(plan);
  expect_back_from_dc(rock);
  EXPECT_NE(dc_of(rock).find("\n0\n0\n0\n0\n0\n2\n"), std::string::npos);
}

}  // namespace
}  // namespace dda
