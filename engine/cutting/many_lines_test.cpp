// Short lines by lot, tens of thousands of them: what cutting costs, and that threads change nothing.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "engine/core/parallel.h"
#include "engine/cutting/cutting_test_support.h"

namespace dda {
namespace {

// One a square metre, of lengths of 2 m in the mean: each crosses two or three others.
RockPlan short_lines(int count) {
  const double size = std::sqrt(count);
  RockPlan plan = square_plan(size);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(0, size), angle(0, std::numbers::pi);
  std::exponential_distribution<double> length(0.5);
  for (int i = 0; i < count; ++i) {
    const double way = angle(random), half = length(random) / 2, x = place(random), y = place(random);
    const Vec2 along(half * std::cos(way), half * std::sin(way)), middle(x, y);
    add_line(plan, {middle - along, middle + along});
  }
  return plan;
}

void expect_same(const CutRock& a, const CutRock& b, int threads) {
  ASSERT_EQ(a.blocks.size(), b.blocks.size()) << threads;
  for (std::size_t i = 0; i < a.blocks.size(); ++i) {
    EXPECT_EQ(a.blocks[i].shape.outer, b.blocks[i].shape.outer) << threads;
    EXPECT_EQ(a.blocks[i].shape.holes, b.blocks[i].shape.holes) << threads;
  }
  ASSERT_EQ(a.cleaned.size(), b.cleaned.size()) << threads;
  for (std::size_t i = 0; i < a.cleaned.size(); ++i) {
    EXPECT_EQ(a.cleaned[i].from, b.cleaned[i].from) << threads;
    EXPECT_EQ(a.cleaned[i].size, b.cleaned[i].size) << threads;
    EXPECT_EQ(a.cleaned[i].origin, b.cleaned[i].origin) << threads;
  }
}

TEST(ManyLines, BlocksAreTheSameWithAnyNumberOfThreads) {
  const RockPlan plan = short_lines(25'000);
  const CutRock alone = cut_rock(plan);
  for (const int threads : {2, 4}) {
    const ThreadsInUse in_use(threads);
    expect_same(alone, cut_rock(plan), threads);
  }
}

// Counts, which are the same on any machine: twice the lines may not be more than twice the work, but for borders of
// squares (a tenth).
TEST(ManyLines, WorkGrowsNoFasterThanTheirNumber) {
  const CutRock half = cut_rock(short_lines(20'000));
  const CutRock whole = cut_rock(short_lines(40'000));
  const auto ratio = [](std::size_t a, std::size_t b) { return static_cast<double>(b) / static_cast<double>(a); };
  EXPECT_LT(ratio(half.pairs_looked_at, whole.pairs_looked_at), 2.2);
  EXPECT_LT(ratio(half.pieces_noded, whole.pieces_noded), 2.2);
  EXPECT_LT(ratio(half.outlines_traced, whole.outlines_traced), 2.2);
  EXPECT_LT(ratio(40'000, whole.pieces_noded), 1.2);       // ends that have nothing near them are not prolonged
  EXPECT_LT(ratio(40'000, whole.pairs_looked_at), 100.0);  // 2.5 crossings a line are found among these
}

}  // namespace
}  // namespace dda
