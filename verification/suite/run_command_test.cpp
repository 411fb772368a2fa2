// `dda-verify run` and the file it writes.
#include "verification/suite/run_command.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/core/temporary_folder.h"
#include "verification/suite/suite_test_support.h"

namespace verify {
namespace {

using Json = nlohmann::ordered_json;

class Run : public testing::Test {
 protected:
  int run(const std::vector<Case>& cases, const Selection& selection = {}) {
    out_.str("");
    errors_.str("");
    return run_cases(cases, {folder_.path() / "new" / "folder", selection}, out_, errors_);
  }
  [[nodiscard]] std::filesystem::path file() const { return folder_.path() / "new/folder/verification.json"; }
  [[nodiscard]] Json entries() const { return Json::parse(dda::read_file(file())).at("cases"); }

  dda::TemporaryFolder folder_;
  std::ostringstream out_;
  std::ostringstream errors_;
};

Case with_order() {
  Assertion assertion = assertion_of(2, 2, 0);
  assertion.order = Order{1.98, 2, 0.1};
  return case_of("ordered", {assertion}, CaseLabel::fast, {4, 26});
}

TEST_F(Run, WritesAnEntryPerAssertion) {
  ASSERT_EQ(run({case_of("exact", {assertion_of(2, 2, 0), assertion_of(3, 2, 0.6)}), with_order()}), 0);
  const Json all = entries();
  ASSERT_EQ(all.size(), 3U);
  std::string keys;
  for (const auto& [key, value] : all[0].items()) keys += key + " ";
  EXPECT_EQ(keys,
            "id title catalogue quantity unit value reference source error tolerance tolerance_reason order "
            "order_expected passed cpu_s counters ");
  EXPECT_EQ(all[1].at("value"), 3);
  EXPECT_EQ(all[1].at("reference"), 2);
  EXPECT_EQ(all[1].at("error"), 0.5);
  EXPECT_EQ(all[1].at("tolerance"), 0.6);
  EXPECT_EQ(all[1].at("quantity"), "slip");
  EXPECT_EQ(all[1].at("unit"), "m");
  EXPECT_EQ(all[1].at("source"), "g t^2/2");
  EXPECT_EQ(all[1].at("tolerance_reason"), "theory");
  EXPECT_EQ(all[1].at("passed"), true);
  EXPECT_TRUE(all[1].at("order").is_null());
  EXPECT_TRUE(all[1].at("order_expected").is_null());
  EXPECT_EQ(all[2].at("order"), 1.98);
  EXPECT_EQ(all[2].at("order_expected"), 2);
  EXPECT_EQ(all[2].at("catalogue"), Json({4, 26}));
  EXPECT_EQ(all[2].at("counters").size(), dda::counter_fields.size());
  EXPECT_EQ(all[2].at("counters").at("contact_state_changes"), 3);
  EXPECT_EQ(errors_.str(), "");
}

TEST_F(Run, FailsAndNamesEveryFailedRow) {
  EXPECT_EQ(run({case_of("good", {assertion_of(2, 2, 0)}), case_of("bad", {assertion_of(2.5, 2, 1e-3)})}), 1);
  EXPECT_EQ(errors_.str(),
            "dda-verify: failed: bad (catalogue 9), slip: value 2.5 m, reference 2 m (g t^2/2), error 0.25, tolerance "
            "0.001 (theory)\n");
  EXPECT_EQ(entries().at(1).at("passed"), false);
  EXPECT_NE(out_.str().find("1 of 1 FAILED"), std::string::npos) << out_.str();
}

TEST_F(Run, WhatIsNotFiniteIsNullAndFails) {
  EXPECT_EQ(run({case_of("lost", {assertion_of(std::numeric_limits<double>::quiet_NaN(), 2, 1)})}), 1);
  EXPECT_TRUE(entries().at(0).at("value").is_null());
  EXPECT_EQ(entries().at(0).at("passed"), false);
}

TEST_F(Run, AMistakeLeavesTheFileOfBefore) {
  ASSERT_EQ(run({with_order()}), 0);
  const std::string before = dda::read_file(file());
  EXPECT_THROW(run({with_order()}, {{"no-such-case"}, {}}), dda::InputError);
  EXPECT_EQ(dda::read_file(file()), before);
}

TEST_F(Run, AFolderThatCannotBeWrittenIsFoundBeforeAnythingRuns) {
  std::filesystem::create_directories(folder_.path() / "new/folder/verification.json.tmp");
  bool has_run = false;
  const auto note = [&] {
    has_run = true;
    return Outcome();
  };
  EXPECT_THROW(run({{"noted", "", {1}, CaseLabel::fast, note}}), std::runtime_error);
  EXPECT_FALSE(has_run);
}

TEST_F(Run, TheFileIsReadBackAsItWas) {
  ASSERT_EQ(run({with_order()}), 0);
  const std::string text = dda::read_file(file());
  EXPECT_EQ(to_json(rows_from_json(text, "")), text);
  EXPECT_THROW(static_cast<void>(rows_from_json("{\"cases\": [{}]}", "a.json")), dda::InputError);
  EXPECT_THROW(static_cast<void>(rows_from_json("{", "a.json")), dda::InputError);
}

TEST(ListCases, NamesNumbersLabelIdAndTitle) {
  std::ostringstream out;
  list_cases({case_of("slow-one", {}, CaseLabel::slow, {4, 26})}, out);
  for (const char* part : {"4,26", "slow", "slow-one", "Title of slow-one"})
    EXPECT_NE(out.str().find(part), std::string::npos) << out.str();
}

}  // namespace
}  // namespace verify
