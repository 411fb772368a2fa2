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
