// Cases run and judged, and which are run.
#include "verification/suite/runner.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <stdexcept>
#include <thread>

#include "engine/core/error.h"
#include "verification/suite/suite_test_support.h"

namespace verify {
namespace {

bool passes(const Assertion& assertion) { return run_case(case_of("one", {assertion})).at(0).passed; }

Assertion with_order(double observed) {
  Assertion assertion = assertion_of(2, 2, 1e-3);
  assertion.order = Order{observed, 2, 0.1};
  return assertion;
}

TEST(RunCase, JudgesErrorsFromBothSides) {
  EXPECT_TRUE(passes(assertion_of(2.001, 2, 1e-3)));
  EXPECT_FALSE(passes(assertion_of(2.003, 2, 1e-3)));
  EXPECT_FALSE(passes(assertion_of(1.997, 2, 1e-3)));
  EXPECT_FALSE(passes(assertion_of(std::numeric_limits<double>::quiet_NaN(), 2, 1e-3)));
}

TEST(RunCase, JudgesOrdersFromBothSides) {
  EXPECT_TRUE(passes(with_order(1.95)));
  EXPECT_FALSE(passes(with_order(1.85)));
  EXPECT_FALSE(passes(with_order(2.15)));
  EXPECT_FALSE(passes(with_order(std::numeric_limits<double>::quiet_NaN())));
}

TEST(RunCase, GivesARowPerAssertion) {
  const std::vector<Row> rows = run_case(case_of("two", {assertion_of(1, 1, 0), assertion_of(3, 1, 0)}));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_TRUE(rows[0].passed);
  EXPECT_FALSE(rows[1].passed);
  for (const Row& row : rows) {
    EXPECT_EQ(row.id, "two");
    EXPECT_EQ(row.title, "Title of two");
    EXPECT_EQ(row.catalogue, std::vector<int>{9});
    EXPECT_EQ(row.counters.steps, 7);
  }
}

void expect_not_completed(const std::function<Outcome()>& run, const std::string& why) {
  const std::vector<Row> rows = run_case({"broken", "Broken", {1}, CaseLabel::fast, run});
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_FALSE(rows[0].passed);
  EXPECT_EQ(rows[0].assertion.quantity, "completed");
  EXPECT_NE(describe(rows[0]).find(why), std::string::npos) << describe(rows[0]);
}

TEST(RunCase, ACaseThatDoesNotCompleteIsAFailedRow) {
  expect_not_completed([]() -> Outcome { throw std::runtime_error("stopped at 2 s: contacts 3-4"); }, "contacts 3-4");
  expect_not_completed([]() -> Outcome { throw 7; }, "no std::exception");
  expect_not_completed([] { return Outcome(); }, "asserted nothing");
}

TEST(RunCase, CountsTheTimeOfTheProcessorNotOfTheClock) {
  const auto sleep = [] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    return Outcome{{assertion_of(1, 1, 0)}, {}};
  };
  const auto compute = [] {
    volatile double sum = 0;
    for (int i = 0; i < 20'000'000; ++i) sum = sum + i;
    return Outcome{{assertion_of(1, 1, 0)}, {}};
  };
  const double asleep = run_case({"sleeps", "", {1}, CaseLabel::fast, sleep})[0].cpu_s;
  const double busy = run_case({"computes", "", {1}, CaseLabel::fast, compute})[0].cpu_s;
  EXPECT_LT(asleep, 0.02);
  EXPECT_GT(busy, 0.002);
}

class Select : public testing::Test {
 protected:
  [[nodiscard]] std::string ids(const Selection& selection) const {
    std::string ids;
    for (const Case& each : select(cases_, selection)) ids += each.id + " ";
    return ids;
  }
  [[nodiscard]] std::string complaint(const Selection& selection) const {
    try {
      return "nothing wrong with " + ids(selection);
    } catch (const dda::InputError& error) {
      return error.what();
    }
  }

  std::vector<Case> cases_ = {case_of("incline-slides", {}), case_of("incline-sticks", {}, CaseLabel::slow),
                              case_of("rocking", {})};
};

TEST_F(Select, ByIdAndLabelInTheOrderOfTheList) {
  EXPECT_EQ(ids({}), "incline-slides incline-sticks rocking ");
  EXPECT_EQ(ids({{"rocking", "incline-slides"}, {}}), "incline-slides rocking ");
  EXPECT_EQ(ids({{}, {"fast"}}), "incline-slides rocking ");
  EXPECT_EQ(ids({{}, {"slow", "fast"}}), "incline-slides incline-sticks rocking ");
  EXPECT_EQ(ids({{"rocking", "incline-sticks"}, {"slow"}}), "incline-sticks ");
}

TEST_F(Select, NamesTheNearestOfWhatIsNotThere) {
  EXPECT_EQ(complaint({{"rocking", "incline-slide"}, {}}),
            "--case is \"incline-slide\", expected an id that `dda-verify run --list` shows; did you mean "
            "\"incline-slides\"?");
  EXPECT_EQ(complaint({{}, {"fats"}}), "--label is \"fats\", expected fast or slow; did you mean \"fast\"?");
  EXPECT_EQ(complaint({{"something else"}, {}}),
            "--case is \"something else\", expected an id that `dda-verify run --list` shows");
}

TEST_F(Select, IdsWithoutTheLabelAreAMistake) {
  EXPECT_NE(complaint({{"rocking"}, {"slow"}}).find("the selection is empty"), std::string::npos);
}

}  // namespace
}  // namespace verify
