// docs/verification.md: written, compared, written anew in part.
#include <gtest/gtest.h>

#include <sstream>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/core/temporary_folder.h"
#include "engine/record/atomic_file.h"
#include "verification/suite/catalogue.h"
#include "verification/suite/page.h"
#include "verification/suite/run_command.h"
#include "verification/suite/suite_test_support.h"
#include "verification/suite/table_command.h"

namespace verify {
namespace {

Lines table_of(const Assertion& assertion) { return page_table(run_case(case_of("one", {assertion}))); }

std::string row_of(const Assertion& assertion) { return table_of(assertion).at(2); }

Assertion with_error(double error, double tolerance = 1e-3) {
  Assertion assertion = assertion_of(2, 2, tolerance);
  assertion.error = error;
  return assertion;
}

Assertion with_order(double observed) {
  Assertion assertion = assertion_of(2, 2, 1);
  assertion.order = Order{observed, 2, 0.1};
  return assertion;
}

TEST(PageTable, RoundsWhatItPrints) {
  EXPECT_EQ(row_of(assertion_of(2.00012345678, 2, 0.01)), "| slip [m] | 2.00012 | 2 (a) | 6.2e-5 | 0.01 (b) |");
  EXPECT_EQ(row_of(assertion_of(-5e9, -5e9, 0.01)), "| slip [m] | -5e9 | -5e9 (a) | < 1e-12 | 0.01 (b) |");
  EXPECT_EQ(table_of(assertion_of(2, 2, 1)).at(4), "- (a) g t^2/2");
  EXPECT_EQ(table_of(assertion_of(2, 2, 1)).at(5), "- (b) theory");
  EXPECT_EQ(row_of(with_order(1.9777)), "| slip [m] | 2 | 2 (a) | < 1e-12 | 1 (b) | 1.98 (2) |");
}

TEST(PageTable, ErrorsOfRoundOffAreBounds) {
  EXPECT_EQ(row_of(with_error(-3e-15)), "| slip [m] | 2 | 2 (a) | < 1e-12 | 0.001 (b) |");
  EXPECT_EQ(row_of(with_error(2e-11)), "| slip [m] | 2 | 2 (a) | < 1e-10 | 0.001 (b) |");
  EXPECT_EQ(row_of(with_error(5e-11)), "| slip [m] | 2 | 2 (a) | < 1e-9 | 0.001 (b) |");
  EXPECT_EQ(row_of(with_error(5e-9, 1e-8)), "| slip [m] | 2 | 2 (a) | < 1e-8 | 1e-8 (b) |")
      << "not above the tolerance";
  const Assertion creep = {"creep", "m", -4e-13, 0, "none", -4e-13, 1e-9, "theory"};
  EXPECT_EQ(row_of(creep), "| creep [m] | < 1e-11 | 0 (a) | < 1e-11 | 1e-9 (b) |");
}

TEST(PageTable, CountsAreExact) {
  const Assertion cells = {"cells misjudged", "-", 0, 0, "none", 0, 0, "all of them"};
  EXPECT_EQ(row_of(cells), "| cells misjudged [-] | 0 | 0 (a) | 0 | 0 (b) |");
}

TEST(PageTable, TextsDoNotBreakCells) {
  Assertion assertion = assertion_of(2, 2, 1);
  assertion.quantity = "|R|, a*b*c";
  EXPECT_EQ(row_of(assertion), "| \\|R\\|, a\\*b\\*c [m] | 2 | 2 (a) | < 1e-12 | 1 (b) |");
  EXPECT_TRUE(differences(table_of(assertion), table_of(assertion)).empty());
}

bool is_fresh(const Assertion& printed, const Assertion& measured) {
  return differences(table_of(printed), table_of(measured)).empty();
}

TEST(PageTable, ANumberIsFreshWithinWhatIsPrinted) {
  EXPECT_TRUE(is_fresh(with_error(4.0e-5, 1e-4), with_error(4.1e-5, 1e-4)));
  EXPECT_FALSE(is_fresh(with_error(4.0e-5, 1e-4), with_error(4.5e-5, 1e-4)));
  EXPECT_FALSE(is_fresh(with_error(4.0e-5, 1e-4), with_error(-4.0e-5, 1e-4)));
  EXPECT_TRUE(is_fresh(with_error(4.0e-5, 1e-2), with_error(4.5e-5, 1e-2))) << "a fiftieth of the tolerance";
  EXPECT_TRUE(is_fresh(with_order(1.98), with_order(1.99)));
  EXPECT_FALSE(is_fresh(with_order(1.98), with_order(2.02)));
  EXPECT_FALSE(is_fresh(with_order(1.98), assertion_of(2, 2, 1)));
  EXPECT_TRUE(is_fresh(assertion_of(2.00012, 2, 1e-4), assertion_of(2.00012001, 2, 1e-4)));
  EXPECT_FALSE(is_fresh(assertion_of(2.00012, 2, 1e-4), assertion_of(2.00022, 2, 1e-4)));
  EXPECT_FALSE(is_fresh(with_error(0, 1e-4), with_error(0, 2e-4))) << "another tolerance";
}

TEST(PageTable, ABoundIsFreshWhileItIsNearlyTrue) {
  EXPECT_TRUE(is_fresh(with_error(1e-15), with_error(6e-15)));
  EXPECT_TRUE(is_fresh(with_error(3e-12), with_error(4e-12))) << "the next power of ten";
  EXPECT_TRUE(is_fresh(with_error(1e-14, 1e-8), with_error(6e-12, 1e-8))) << "a fiftieth of the tolerance";
  EXPECT_FALSE(is_fresh(with_error(3e-12, 1e-8), with_error(4e-10, 1e-8)));
  EXPECT_FALSE(is_fresh(with_error(3e-12, 1e-6), with_error(1e-7, 1e-6)));
  EXPECT_FALSE(is_fresh(with_error(1e-6, 1e-5), with_error(3e-12, 1e-5)));
}

TEST(PageTable, ATextIsFreshOnlyAsItIs) {
  Assertion other = assertion_of(2, 2, 1);
  other.source = "g t^2/3";
  EXPECT_FALSE(is_fresh(assertion_of(2, 2, 1), other));
  other = assertion_of(2, 2, 1);
  other.tolerance_reason = "measured";
  EXPECT_FALSE(is_fresh(assertion_of(2, 2, 1), other));
  other = assertion_of(2, 2, 1);
  other.quantity = "path";
  EXPECT_FALSE(is_fresh(assertion_of(2, 2, 1), other));
}

// ---- The page and the command that makes it.

class TablePage : public testing::Test {
 protected:
  void measure(const std::vector<Case>& cases, const std::string& folder = "results") {
    run_cases(cases, {folder_.path() / folder, {}}, out_, out_);
  }
  int table(const std::vector<Case>& cases, bool check, const Selection& selection = {}) {
    errors_.str("");
    return make_table(cases, {folder_.path() / "results", page(), selection, check}, out_, errors_);
  }
  [[nodiscard]] std::filesystem::path page() const { return folder_.path() / "page.md"; }
  [[nodiscard]] std::string text() const { return dda::read_file(page()); }
  [[nodiscard]] bool says(const std::string& part) const { return text().find(part) != std::string::npos; }

  dda::TemporaryFolder folder_;
  std::ostringstream out_;
  std::ostringstream errors_;
  Case incline_ = case_of("incline", {assertion_of(2.1, 2, 0.1)}, CaseLabel::fast, {9, 12});
  Case rocking_ = case_of("rocking", {assertion_of(3, 3, 0.1)}, CaseLabel::slow, {14});
};

TEST_F(TablePage, HasEveryCaseAndWhatIsNotCovered) {
  measure({rocking_, incline_});
  ASSERT_EQ(table({rocking_, incline_}, false), 0) << errors_.str();
  for (const char* part :
       {"3 of the 43 problems are covered, by 2 cases",
        "## 9. Block on an incline\n\n### `incline`: Title of incline\n",
        "## 12. Sliding to rest\n\nSee `incline` under number 9.\n", "### `rocking`: Title of rocking (label slow)\n",
        "| slip [m] | 2.1 | 2 (a) | 0.05 | 0.1 (b) |", "## Not yet covered\n\n- 1 Free fall\n",
        "- 13 Driven stick-slip\n- 15 "})
    EXPECT_TRUE(says(part)) << part;
  EXPECT_LT(text().find("`incline`: "), text().find("`rocking`: "));
  EXPECT_EQ(table({rocking_, incline_}, true), 0) << errors_.str();
}

// Which area has which figures, of what is printed: 0.05 of a tolerance of 0.1, and round-off.
TEST_F(TablePage, OpensWithASummaryByArea) {
  const Case near = case_of("near", {assertion_of(2.1, 2, 0.1), assertion_of(2, 2, 0.1)}, CaseLabel::fast, {10});
  measure({incline_, near, rocking_});
  ASSERT_EQ(table({incline_, near, rocking_}, false), 0) << errors_.str();
  EXPECT_TRUE(says("| Friction and shaking | 9 to 13 | 2 | 3 | 50 % of it: `incline`, slip [m] |\n"));
  EXPECT_TRUE(says("| Rocking and toppling | 14 to 17 | 1 | 1 | all round-off or exact |\n"));
  EXPECT_FALSE(says("| Free motion"));
  EXPECT_LT(text().find("| Friction and shaking"), text().find("## 9."));
  std::string changed = text();
  changed.replace(changed.find("50 % of it"), 2, "40");
  dda::write_file(page(), changed);
  EXPECT_EQ(table({incline_, near, rocking_}, true), 1) << "a summary that is not so";
}

TEST_F(TablePage, SaysSoWhereNothingIsLeft) {
  std::vector<int> all;
  for (const CatalogueProblem& problem : catalogue()) all.push_back(problem.number);
  const Case everything = case_of("incline", {assertion_of(2.1, 2, 0.1)}, CaseLabel::fast, all);
  measure({everything});
  ASSERT_EQ(table({everything}, false), 0) << errors_.str();
  EXPECT_TRUE(says("All 43 problems are covered, by 1 cases.\n"));
  EXPECT_FALSE(says("listed at the end"));
  EXPECT_FALSE(says("Not yet covered"));
  EXPECT_EQ(table({everything}, true), 0) << errors_.str();
}

TEST_F(TablePage, KeepsTheTablesOfCasesThatWereNotRun) {
  measure({rocking_, incline_});
  ASSERT_EQ(table({rocking_, incline_}, false), 0);
  const std::string before = text();
  measure({incline_});
  ASSERT_EQ(table({rocking_, incline_}, false), 0);
  EXPECT_EQ(text(), before);
  const Case changed = case_of("incline", {assertion_of(2.06, 2, 0.1)}, CaseLabel::fast, {9, 12});
  measure({changed});
  ASSERT_EQ(table({rocking_, changed}, false), 0);
  EXPECT_TRUE(says("| 2.06 | 2 (a) | 0.03 |"));
  EXPECT_TRUE(says("| 3 | 3 (a) |"));
}

TEST_F(TablePage, ACaseWithoutATableIsAMistake) {
  measure({incline_});
  EXPECT_THROW(table({rocking_, incline_}, false), dda::InputError);
  EXPECT_FALSE(std::filesystem::exists(page()));
}

TEST_F(TablePage, IsStaleWhenAMeasurementAnIdOrATitleChanges) {
  measure({incline_, rocking_});
  ASSERT_EQ(table({incline_, rocking_}, false), 0);
  Case retitled = incline_;
  retitled.title = "Another title";
  EXPECT_EQ(table({retitled, rocking_}, true), 1);
  EXPECT_EQ(table({incline_}, true), 1) << "a case is gone";
  Case moved = rocking_;
  moved.catalogue = {15};
  EXPECT_EQ(table({incline_, moved}, true), 1);
  EXPECT_EQ(table({incline_, rocking_, case_of("new", {assertion_of(1, 1, 1)})}, true), 1);

  measure({case_of("incline", {assertion_of(2.15, 2, 0.1)}), rocking_});
  EXPECT_EQ(table({incline_, rocking_}, true), 1);
  EXPECT_NE(errors_.str().find("incline: slip [m]: value is printed as \"2.1\", measured is \"2.15\""),
            std::string::npos)
      << errors_.str();
  EXPECT_NE(errors_.str().find("dda-verify table results/verification --out docs/verification.md"), std::string::npos);
  EXPECT_EQ(table({incline_, rocking_}, true, {{"rocking"}, {}}), 0) << "only what is selected is compared";
}

TEST_F(TablePage, TakesAFolderForEachCase) {
  measure({incline_}, "results/incline");
  measure({rocking_}, "results/rocking");
  ASSERT_EQ(table({incline_, rocking_}, false), 0) << errors_.str();
  EXPECT_EQ(table({incline_, rocking_}, true), 0) << errors_.str();
  std::filesystem::remove_all(folder_.path() / "results/rocking");
  EXPECT_EQ(table({incline_, rocking_}, true), 1) << "not measured";
  EXPECT_EQ(table({incline_, rocking_}, true, {{}, {"fast"}}), 0);
}

TEST_F(TablePage, ALabelWithoutCasesHasNothingToCompare) {
  measure({incline_});
  ASSERT_EQ(table({incline_}, false), 0);
  EXPECT_EQ(table({incline_}, true, {{}, {"slow"}}), 0) << errors_.str();
}

TEST_F(TablePage, AFailedRowDoesNotGetIn) {
  const Case failing = case_of("incline", {assertion_of(2.5, 2, 0.1)});
  measure({failing});
  EXPECT_EQ(table({failing}, false), 1);
  EXPECT_NE(errors_.str().find("failed: incline"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(page()));
}

TEST_F(TablePage, ResultsThatAreNotThereAreAMistake) { EXPECT_THROW(table({incline_}, false), dda::InputError); }

TEST(Catalogue, AreasHoldEveryProblemOnce) {
  int next = 1;
  for (const Area& area : areas()) {
    EXPECT_EQ(area.first, next) << area.title;
    next = area.last + 1;
  }
  EXPECT_EQ(next, static_cast<int>(catalogue().size()) + 1);
}

TEST(Catalogue, IsNumberedFromOneWithoutGaps) {
  for (std::size_t i = 0; i < catalogue().size(); ++i) EXPECT_EQ(catalogue()[i].number, static_cast<int>(i) + 1);
}

}  // namespace
}  // namespace verify
