#include "verification/suite/expect.h"

#include <gtest/gtest.h>

namespace verify {
namespace {

TEST(Expect, IsRelativeToTheReferenceUnlessItSaysOtherwise) {
  const MeasuredQuantity slip = expect("slip", "m").is(1.02);
  EXPECT_EQ(slip.against(1, "theory").within(0.01, "why").error, relative_error(1.02, 1));
  EXPECT_DOUBLE_EQ(slip.against(4, "theory").absolutely().within(0.01, "why").error, -2.98);
  EXPECT_DOUBLE_EQ(slip.against(0, "theory").off_by(0.5).within(0.01, "why").error, 0.5);
}

TEST(Expect, KeepsWhatItIsTold) {
  const Assertion assertion =
      expect("slip", "m").is(2).against(1, "theory").of_order({1.9, 2, 0.2}).within(0.25, "measured");
  EXPECT_EQ(assertion.quantity, "slip");
  EXPECT_EQ(assertion.unit, "m");
  EXPECT_EQ(assertion.value, 2);
  EXPECT_EQ(assertion.reference, 1);
  EXPECT_EQ(assertion.source, "theory");
  EXPECT_EQ(assertion.tolerance, 0.25);
  EXPECT_EQ(assertion.tolerance_reason, "measured");
  ASSERT_TRUE(assertion.order);
  EXPECT_EQ(assertion.order->observed, 1.9);
  EXPECT_FALSE(passed(assertion));
}

TEST(Expect, NothingPassesWithoutAReference) {
  EXPECT_FALSE(passed(expect("slip", "m").is(1).against(0, "nobody said off what").within(1e9, "any")));
}

}  // namespace
}  // namespace verify
