#include "engine/cutting/rock_statistics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/cutting/cutting_test_support.h"

namespace dda {
namespace {

TEST(RockStatistics, AreThoseOfARegularGrid) {
  RockPlan plan = square_plan();
  for (int i = 1; i < 10; ++i) add_line(plan, {{0, double(i)}, {10, double(i)}});
  add_line(plan, {{3, 0}, {3, 10}});
  add_line(plan, {{3.05, 0}, {3.05, 10}});  // between them pieces of 5 cm, which are not sound
  const RockStatistics statistics = statistics_of(cut_rock(plan));
  EXPECT_NEAR(statistics.mean_area, 100.0 / 30, 1e-12);
  EXPECT_NEAR(statistics.area_shares[0], 0.05, 1e-12);
  EXPECT_NEAR(statistics.area_shares[1], 3, 1e-12);
  EXPECT_NEAR(statistics.area_shares[2], 6.95, 1e-12);
  EXPECT_NEAR(statistics.p20, 11.0 / 100, 1e-12);
  EXPECT_NEAR(statistics.p21, 110.0 / 100, 1e-12);
  EXPECT_NEAR(statistics.rqd_level, 0.995, 1e-12);
  EXPECT_NEAR(statistics.rqd_upright, 1, 1e-12);
}

TEST(RockStatistics, ALevelThroughAHoleHasTwoPieces) {
  RockPlan plan = square_plan();
  plan.holes.push_back({{4, 4}, {6, 4}, {6, 6}, {4, 6}});
  const auto pieces = pieces_on_level(cut_rock(plan).blocks, 5);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_NEAR(pieces[0], 4, 1e-12);
  EXPECT_NEAR(pieces[1], 4, 1e-12);
}

// 3 m level, drawn either way; 4 m at 45 degrees; 1 m upright; 2 m that fall to the right by 30 degrees.
TEST(RockStatistics, RoseHasTheLengthInEachDirection) {
  const double half = std::sqrt(0.5), cosine = std::sqrt(0.75);
  const auto shares = length_rose({{{0, 0}, {1, 0}, ""},
                                   {{3, 0}, {1, 0}, ""},
                                   {{0, 0}, {4 * half, 4 * half}, ""},
                                   {{2, 5}, {2, 4}, ""},
                                   {{0, 0}, {2 * cosine, -1}, ""}});
  ASSERT_EQ(shares.size(), 18U);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const double length = i == 0 ? 3 : i == 4 ? 4 : i == 9 ? 1 : i == 15 ? 2 : 0;
    EXPECT_NEAR(shares[i], length / 10, 1e-12) << i;
  }
}

TEST(RockStatistics, RoseWithoutJointsIsEmpty) {
  for (const double share : length_rose({})) EXPECT_EQ(share, 0);
}

}  // namespace
}  // namespace dda
