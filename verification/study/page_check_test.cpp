// A page that was made earlier against what is made now.
#include "verification/study/page_check.h"

#include <gtest/gtest.h>

namespace verify {
namespace {

bool is_stale(std::string_view printed, std::string_view made) { return !stale_lines(printed, made).empty(); }

TEST(PageCheck, NumbersMayDifferByTheirLastDigit) {
  EXPECT_FALSE(is_stale("| dry | 3.49 | +9.2 |", "| dry | 3.49 | +9.2 |"));
  EXPECT_FALSE(is_stale("| dry | 3.49 | +9.2 |", "| dry | 3.50 | +9.1 |"));
  EXPECT_TRUE(is_stale("| dry | 3.49 |", "| dry | 3.51 |"));
  EXPECT_TRUE(is_stale("| dry | 3.49 |", "| dry | 3.4901 |")) << "another number of digits";
  EXPECT_FALSE(is_stale("by 32 and 30 %", "by 32 and 31 %"));
  EXPECT_TRUE(is_stale("by 32 and 30 %", "by 32 and 34 %"));
  EXPECT_TRUE(is_stale("dt = 1e-05 s", "dt = 1e-08 s"));
}

TEST(PageCheck, MayAllowMoreLastDigits) {
  EXPECT_TRUE(stale_lines("| 3.49 |", "| 3.54 |", 5).empty());
  EXPECT_FALSE(stale_lines("| 3.49 |", "| 3.55 |", 5).empty());
}

TEST(PageCheck, SignsAreOfTheNumber) {
  EXPECT_FALSE(is_stale("| -0.0 |", "| +0.0 |"));
  EXPECT_FALSE(is_stale("| -0.0 |", "| +0.1 |"));
  EXPECT_TRUE(is_stale("| -0.2 |", "| +0.2 |"));
  EXPECT_TRUE(is_stale("1-2", "1+2"));
}

TEST(PageCheck, TextsAndLinesAreTheSame) {
  EXPECT_TRUE(is_stale("dry joints 1", "wet joints 1"));
  EXPECT_TRUE(is_stale("a 1", "a 1 b"));
  EXPECT_TRUE(is_stale("a 1", "a 1 2"));
  EXPECT_FALSE(is_stale("a\n\nb\n", "a\n\nb"));
  EXPECT_TRUE(is_stale("a\nb\n", "a\n"));
  EXPECT_TRUE(is_stale("", "a 1"));
  ASSERT_EQ(stale_lines("a 1\nb 2\n", "a 1\nb 4\n").size(), 1U);
  EXPECT_EQ(stale_lines("a 1\nb 2\n", "a 1\nb 4\n").front(), "\"b 2\" is printed, it should be \"b 4\"");
}

}  // namespace
}  // namespace verify
