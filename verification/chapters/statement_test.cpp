#include "verification/chapters/statement.h"

#include <gtest/gtest.h>

#include "verification/chapters/linear_fit.h"

namespace verify {
namespace {

Statement judged(const std::vector<Reading>& readings) {
  return judged_over({3, "id", "text", std::string("theirs"), std::string(), "", std::nullopt, "Rule."}, readings);
}

TEST(Statement, HoldsWhereMostReadingsThatCanTellSaySo) {
  const Statement s = judged({{"a", true, "1"}, {"b", true, "2"}, {"c", false, "3"}, {"d", std::nullopt, "no run"}});
  EXPECT_EQ(s.confirmed, true);
  EXPECT_EQ(std::get<std::string>(s.ours), "confirmed for 2 of 3 readings");
  EXPECT_EQ(s.reason, "Rule. It does not hold in: c (3). Not told by: d (no run).");
}

TEST(Statement, DoesNotHoldWhereFewDo) {
  const Statement s = judged({{"a", true, "1"}, {"b", false, "2"}, {"c", false, "3"}});
  EXPECT_EQ(s.confirmed, false);
  EXPECT_EQ(s.reason, "Rule. It holds in: a (1). It does not hold in: b (2); c (3).");
}

TEST(Statement, IsOpenWhereReadingsAreEquallyDividedOrCannotTell) {
  EXPECT_EQ(judged({{"a", true, ""}, {"b", false, ""}}).confirmed, std::nullopt);
  EXPECT_EQ(judged({{"a", std::nullopt, ""}}).confirmed, std::nullopt);
}

TEST(Statement, SaysThatNothingWasRunForIt) {
  const Statement s = judged({});
  EXPECT_EQ(s.confirmed, std::nullopt);
  EXPECT_EQ(std::get<std::string>(s.ours), "not judged");
  EXPECT_EQ(s.reason, "Rule. No run was made for it.");
}

// The limit of 95 % for a linear trend over the stresses of Table 6.1 rests on the last two.
TEST(LinearFit, TellsALineFromARootAndASquare) {
  const std::vector<double> stress{0, 10, 30, 50};
  const LinearFit line = fit_line(stress, {1, 3, 7, 11});
  EXPECT_NEAR(line.slope, 0.2, 1e-14);
  EXPECT_NEAR(line.explained, 1, 1e-14);
  EXPECT_NEAR(fit_line(stress, {0, std::sqrt(10), std::sqrt(30), std::sqrt(50)}).explained, 0.92, 0.005);
  EXPECT_NEAR(fit_line(stress, {0, 100, 900, 2500}).explained, 0.93, 0.005);
}

}  // namespace
}  // namespace verify
