#include "engine/cutting/rock_statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/cutting/cut_rock.h"
#include "engine/cutting/cutting_test_support.h"
#include "engine/cutting/joint_sets.h"

namespace dda {
namespace {

TEST(RockStatistics, AreThoseOfARegularGrid) {
  RockPlan plan = square_plan();
  for (int i = 1; i < 10; ++i) add_line(plan, {{0, double(i)}, {10, double(i)}});
  add_line(plan, {{3, 0}, {3, 10}});
  add_line(plan, {{3.05, 0}, {3.05, 10}});  // between them pieces of 5 cm, which are not sound
  const RockStatistics statistics = statistics_of(cut_rock(plan), plan);
  EXPECT_NEAR(statistics.mean_area, 100.0 / 30, 1e-12);
  EXPECT_NEAR(statistics.area_shares[0], 0.05, 1e-12);
  EXPECT_NEAR(statistics.area_shares[1], 3, 1e-12);
  EXPECT_NEAR(statistics.area_shares[2], 6.95, 1e-12);
  EXPECT_NEAR(statistics.p20, 11.0 / 100, 1e-12);
  EXPECT_NEAR(statistics.p21, 110.0 / 100, 1e-12);
  EXPECT_NEAR(statistics.rqd_level, 0.995, 1e-12);
  EXPECT_NEAR(statistics.rqd_upright, 1, 1e-12);
  EXPECT_NEAR(statistics.p20_traces, 11.0 / 100, 1e-12);
  EXPECT_NEAR(statistics.p21_traces, 110.0 / 100, 1e-12);
  EXPECT_NEAR(statistics.rqd_level_traces, 0.995, 1e-12);
  EXPECT_NEAR(statistics.rqd_upright_traces, 1, 1e-12);
}

// Traces that end within the rock cut nothing, and are in maps all the same. What is drawn outside, in a hole, in an
// opening that is left out, or as a construction line is not; an opening that is a group of blocks is rock.
TEST(RockStatistics, TracesCountAsTheyAreDrawn) {
  RockPlan plan = square_plan();
  plan.holes.push_back({{1, 1}, {3, 1}, {3, 3}, {1, 3}});
  plan.openings.push_back({"tunnel", {{5, 5}, {9, 5}, {9, 9}, {5, 9}}, "", true, "openings[0]"});
  plan.openings.push_back({"shaft", {{1, 6}, {2, 6}, {2, 9}, {1, 9}}, "", false, "openings[1]"});
  add_line(plan, {{0.5, 2}, {4, 2}});              // 1.5 m of 3.5 m beside the hole
  add_line(plan, {{4, 7}, {12, 7}});               // 2 m beside the tunnel and up to the boundary
  add_line(plan, {{0.5, 8}, {2.5, 8}, {2.5, 4}});  // all of 6 m, once
  add_line(plan, {{20, 0}, {20, 10}});
  add_line(plan, {{4, 0.5}, {9, 0.5}});
  plan.lines.back().construction = true;
  const RockStatistics statistics = statistics_of(cut_rock(plan), plan);
  const double area = 100 - 4 - 16;
  EXPECT_NEAR(statistics.p20_traces, 3 / area, 1e-9);
  EXPECT_NEAR(statistics.p21_traces, (1.5 + 2 + 6) / area, 1e-9);
}

// On an upright line, traces 5 cm apart that go from side to side but for a millimetre leave the same as joints.
TEST(RockStatistics, TracesPartSoundPieces) {
  RockPlan plan = square_plan();
  for (int i = 0; i < 40; ++i) add_line(plan, {{1e-3, 5 + 0.05 * i}, {9.999, 5 + 0.05 * i}});
  const RockStatistics statistics = statistics_of(cut_rock(plan), plan);
  EXPECT_EQ(statistics.p21, 0);
  EXPECT_NEAR(statistics.rqd_upright, 1, 1e-12);
  EXPECT_NEAR(statistics.rqd_upright_traces, 1 - 39 * 0.05 / 10, 1e-9);
  EXPECT_NEAR(statistics.rqd_level_traces, 1, 1e-12);
}

// A set in which each trace is followed by a bridge, as `persistence` draws it: of a length of l in l + b.
TEST(RockStatistics, TracesOfASetHaveItsIntensity) {
  RockPlan plan = square_plan(100);
  JointSet set;
  set.dip.mean = std::numbers::pi / 3;
  set.spacing.mean = 1;
  set.length = RandomQuantity{};
  set.length->mean = 8;
  set.bridge.mean = 8 / 0.7 - 8;
  plan.lines = traces_of({set}, plan.boundary, 1);
  const RockStatistics statistics = statistics_of(cut_rock(plan), plan);
  EXPECT_EQ(statistics.p21, 0);
  EXPECT_NEAR(statistics.p21_traces, 0.7, 0.01);
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
