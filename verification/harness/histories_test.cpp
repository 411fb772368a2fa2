#include "verification/harness/histories.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace verify {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(KeepLargest, OfEitherSignAndNeverLosesWhatIsNoNumber) {
  double largest = 0;
  for (const double error : {0.5, -2.0, 1.0}) keep_largest(largest, error);
  EXPECT_EQ(largest, 2);
  for (const double error : {nan, 3.0}) keep_largest(largest, error);
  EXPECT_TRUE(std::isnan(largest));
}

TEST(LargestDifference, IsOfThePeak) {
  EXPECT_EQ(largest_difference({1, -3, 2}, {1, -4, 2.5}), 0.25);
  EXPECT_TRUE(std::isnan(largest_difference({1, nan, 2}, {1, -4, 2})));
  EXPECT_THROW(static_cast<void>(largest_difference({1}, {1, 2})), std::invalid_argument);
}

}  // namespace
}  // namespace verify
