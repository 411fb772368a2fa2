// Lines end to end: what is closed, dropped and trimmed on the way is listed, and what cannot be is said with its
// place.
#include "engine/drawing/join_lines.h"

#include "engine/cutting/cut_rock.h"
#include "engine/drawing/drawing_test_support.h"
#include "engine/drawing/read_formats.h"

namespace dda {
namespace {

OpenLine line(const Vec2& from, const Vec2& to, const std::string& origin) { return {{from, to}, origin}; }

constexpr double reach = 0.01;

std::vector<OpenLine> square() {
  return {line({0, 0}, {4, 0}, "below"), line({4, 0}, {4, 4}, "right"), line({4, 4}, {0, 4}, "above"),
          line({0, 4}, {0, 0}, "left")};
}

void expect_cleaned(const Joined& joined, Cleaning what, const Vec2& from, const Vec2& to, const std::string& origin) {
  for (const Cleaned& each : joined.cleaned) {
    if (each.what != what || (each.from - from).norm() > 1e-12 || (each.to - to).norm() > 1e-12) continue;
    EXPECT_EQ(each.origin, origin);
    EXPECT_NEAR(each.size, (to - from).norm(), 1e-12);
    return;
  }
  ADD_FAILURE() << to_string(what) << " is not listed at " << from.transpose();
}

TEST(JoinLines, WhatIsDrawnSoundlyIsNotCleaned) {
  const Joined joined = join_lines(square(), reach);
  ASSERT_FALSE(joined.gap);
  EXPECT_EQ(joined.rings.size(), 1U);
  EXPECT_TRUE(joined.cleaned.empty());
}

TEST(JoinLines, AGapBelowTheToleranceIsClosedAndListed) {
  std::vector<OpenLine> lines = square();
  lines[1].points[1] = {4, 3.995};
  const Joined joined = join_lines(lines, reach);
  ASSERT_EQ(joined.rings.size(), 1U);
  EXPECT_EQ(joined.cleaned.size(), 1U);
  expect_cleaned(joined, Cleaning::gap_closed, {4, 3.995}, {4, 4}, "right");
}

TEST(JoinLines, AGapOfOneLineWithItself) {
  const Joined joined = join_lines({{{{0, 0}, {4, 0}, {4, 4}, {0.005, 0}}, "triangle"}}, reach);
  ASSERT_EQ(joined.rings.size(), 1U);
  EXPECT_EQ(joined.rings[0].ring.size(), 3U);
  EXPECT_EQ(joined.cleaned.size(), 1U);
  expect_cleaned(joined, Cleaning::gap_closed, {0.005, 0}, {0, 0}, "triangle");
}

TEST(JoinLines, DoubledAndShortLinesAndNearCornersAreListed) {
  std::vector<OpenLine> lines = square();
  lines.push_back(line({4, 0}, {0, 0}, "again"));
  lines.push_back(line({2, 2}, {2, 2.001}, "dot"));
  lines[2].points = {{4, 4}, {2, 4}, {2, 4.002}, {0, 4}};
  const Joined joined = join_lines(lines, reach);
  ASSERT_EQ(joined.rings.size(), 1U);
  EXPECT_EQ(joined.cleaned.size(), 3U);
  expect_cleaned(joined, Cleaning::lines_overlap, {4, 0}, {0, 0}, "again");
  expect_cleaned(joined, Cleaning::line_without_length, {2, 2}, {2, 2.001}, "dot");
  expect_cleaned(joined, Cleaning::short_edge_closed, {2, 4.002}, {2, 4}, "below");
}

TEST(JoinLines, LinesThatRunAlongEachOtherCountOnceWhereTheyDo) {
  std::vector<OpenLine> lines = square();
  lines[0] = line({0, 0}, {3, 0}, "below");
  lines.push_back(line({1, 0}, {4, 0}, "below too"));
  lines.push_back(line({0, 3}, {0, 1}, "left too"));
  const Joined joined = join_lines(lines, reach);
  ASSERT_FALSE(joined.gap) << joined.gap->value;
  ASSERT_EQ(joined.rings.size(), 1U);
  EXPECT_EQ(std::abs(signed_area(joined.rings[0].ring)), 16);
  EXPECT_EQ(joined.cleaned.size(), 2U);
  expect_cleaned(joined, Cleaning::lines_overlap, {1, 0}, {3, 0}, "below too");
  expect_cleaned(joined, Cleaning::lines_overlap, {0, 3}, {0, 1}, "left too");
}

// A line along the outline is no gap of it, wherever it comes in the drawing.
TEST(JoinLines, AShortLineAlongAClosedOne) {
  const OpenLine outline{{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}, "outline"};
  for (const bool first : {true, false}) {
    std::vector<OpenLine> lines{outline};
    lines.insert(first ? lines.begin() : lines.end(), line({1, 0}, {3, 0}, "short"));
    const Joined joined = join_lines(lines, reach);
    ASSERT_EQ(joined.rings.size(), 1U);
    EXPECT_EQ(joined.rings[0].ring.size(), 4U);
    expect_cleaned(joined, Cleaning::lines_overlap, {1, 0}, {3, 0}, "short");
  }
}

TEST(JoinLines, EndsThatStickOutByLessThanTheToleranceAreTrimmed) {
  std::vector<OpenLine> lines = square();
  lines[0].points[1] = {4.008, 0};  // 0.0113 m from the end of the next line
  lines[1].points[0] = {4, -0.008};
  const Joined joined = join_lines(lines, reach);
  ASSERT_FALSE(joined.gap) << joined.gap->value;
  ASSERT_EQ(joined.rings.size(), 1U);
  EXPECT_NEAR(std::abs(signed_area(joined.rings[0].ring)), 16, 1e-12);
  EXPECT_EQ(joined.cleaned.size(), 2U);
  expect_cleaned(joined, Cleaning::dangle_trimmed, {4, 0}, {4.008, 0}, "below");
  expect_cleaned(joined, Cleaning::dangle_trimmed, {4, 0}, {4, -0.008}, "right");
}

// Whichever of the lines at the corner is the one that is too long.
TEST(JoinLines, EndsThatStickOutFurtherAreSaidWithTheirPlace) {
  const auto gap_of = [](std::size_t number, std::size_t end, const Vec2& place) {
    std::vector<OpenLine> lines = square();
    lines[number].points[end] = place;
    const Joined joined = join_lines(lines, reach);
    return joined.gap ? joined.gap->origin + " is " + joined.gap->value : "";
  };
  EXPECT_EQ(gap_of(0, 1, {4.5, 0}),
            "below is too long: it ends 0.5 m beyond the corner at (4, 0) m, where it meets right");
  EXPECT_EQ(gap_of(1, 0, {4, -0.25}),
            "right is too long: it ends 0.25 m beyond the corner at (4, 0) m, where it meets below");
  EXPECT_EQ(gap_of(3, 1, {0, -0.25}),
            "left is too long: it ends 0.25 m beyond the corner at (0, 0) m, where it meets below");
  EXPECT_EQ(gap_of(0, 0, {-0.1, 0}),
            "below is too long: it ends 0.1 m beyond the corner at (0, 0) m, where it meets left");
  EXPECT_EQ(gap_of(0, 1, {3.5, 0}), "below is open at (3.5, 0) m, 0.5 m from the nearest other end, of right");
}

TEST(JoinLines, LinesThatAllCrossAtTheirCorners) {
  const Joined joined = join_lines({line({-1, 0}, {5, 0}, "below"), line({4, -1}, {4, 5}, "right"),
                                    line({5, 4}, {-1, 4}, "above"), line({0, 5}, {0, -1}, "left")},
                                   reach);
  ASSERT_TRUE(joined.gap);
  EXPECT_EQ(joined.gap->origin + " is " + joined.gap->value,
            "below is too long: it ends 1 m beyond the corner at (4, 0) m, where it meets right");
  EXPECT_EQ(joined.gap->expected, "a line that ends at the corner, or a larger \"tolerance\" of the rock in a scene");
}

TEST(JoinLines, WhatWasCleanedComesWithTheBlocks) {
  const RockPlan plan = plan_of(
      read_csv_drawing("layer,x1,y1,x2,y2\nboundary,0,0,4,0\nboundary,4,0,0,4\nboundary,0,4,0,1e-7\n", "p.csv", 0), {});
  const CutRock rock = cut_rock(plan);
  ASSERT_EQ(rock.cleaned.size(), 1U);
  EXPECT_EQ(rock.cleaned[0].what, Cleaning::gap_closed);
  EXPECT_EQ(rock.cleaned[0].from, Vec2(0, 1e-7));
  EXPECT_EQ(rock.cleaned[0].origin, "p.csv line 4 (layer boundary)");
}

}  // namespace
}  // namespace dda
