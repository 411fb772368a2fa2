// Jobs side by side say what jobs one after the other say; command lines become exit codes.
#include "verification/study/jobs.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "engine/core/error.h"
#include "verification/study/command_line.h"
#include "verification/study/grid.h"
#include "verification/study/judged_run.h"
#include "verification/study/values.h"

namespace verify {
namespace {

// The first jobs take longest, so that they end last.
std::string slow_at_first(std::size_t index) {
  std::this_thread::sleep_for(std::chrono::milliseconds(index < 2 ? 60 : 1));
  return std::string(index, 'x') + '\n';
}

std::string all_texts(std::size_t count, int at_once, const Job& job) {
  std::string all;
  run_jobs(count, at_once, job,
           [&](std::size_t index, const std::string& text) { all += std::to_string(index) + text; });
  return all;
}

TEST(Jobs, GiveTheSameInTheSameOrderHoweverManyAtOnce) {
  const std::string one_by_one = all_texts(9, 1, slow_at_first);
  EXPECT_EQ(one_by_one.substr(0, 7), "0\n1x\n2x");
  for (const int at_once : {2, 4, 20}) EXPECT_EQ(all_texts(9, at_once, slow_at_first), one_by_one);
}

TEST(Jobs, RunInCopiesWhenThereAreSeveralAtOnce) {
  const auto process = [](std::size_t) { return std::to_string(::getpid()); };
  EXPECT_EQ(all_texts(1, 1, process), "0" + std::to_string(::getpid()));
  EXPECT_NE(all_texts(1, 2, process), "0" + std::to_string(::getpid()));
}

TEST(Jobs, ThatCrashAreTold) {
  const auto crashing = [](std::size_t index) {
    if (index == 1) ::abort();
    return std::to_string(index);
  };
  EXPECT_THROW((void)all_texts(3, 2, crashing), std::runtime_error);
  const auto throwing = [](std::size_t) -> std::string { throw std::runtime_error("no"); };
  EXPECT_THROW((void)all_texts(1, 1, throwing), std::runtime_error);
  EXPECT_THROW((void)all_texts(1, 2, throwing), std::runtime_error);
}

TEST(Grid, HasEveryCombinationAndTheLastAxisIsFastest) {
  std::vector<std::string> items = {""};
  for (const std::string& axis : {std::string("ab"), std::string("xyz")})
    items = with_each(items, axis, [](char value, std::string& item) { item += value; });
  EXPECT_EQ(items, (std::vector<std::string>{"ax", "ay", "az", "bx", "by", "bz"}));
  EXPECT_EQ(geometric(1, 8, 2).size(), 4U);
  EXPECT_DOUBLE_EQ(geometric(1, 8, 2)[2], 4);
}

TEST(JudgedRun, ReasonsComeBackFromJson) {
  JudgedRun run;
  run.message = "why";
  run.said = {"a", "b"};
  run.checks = {{"depth", 0.1 + 0.2, 1}, {"energy", std::nan(""), 2}};
  nlohmann::ordered_json json, again;
  add_reasons(run, json);
  JudgedRun read;
  read_reasons(json, read);
  add_reasons(read, again);
  EXPECT_EQ(again.dump(), json.dump());
  EXPECT_TRUE(read.checks[0].value == run.checks[0].value && !read.checks[1].holds());
}

TEST(Csv, QuotesOnlyWhatItMust) {
  EXPECT_EQ(
      csv_line({csv_cell(std::string("a")), csv_cell(std::string("b,\"c\"\n")), csv_cell(nlohmann::ordered_json())}),
      "a,\"b,\"\"c\"\" \",\n");
}

struct Tilt {
  std::filesystem::path folder, page;
  int angle = 3;
  std::vector<int> steps;
  bool quick = false;
};

class TiltProgram : public testing::Test {
 protected:
  int run(const std::vector<const char*>& options) {
    std::vector<const char*> words(options.size() + 1, "tilt");
    std::copy(options.begin(), options.end(), words.begin() + 1);
    errors_.str("");
    return run_command_line("tilt", "", {command_}, static_cast<int>(words.size()), words.data(), out_, errors_);
  }

  Tilt seen_;
  std::ostringstream out_, errors_;
  StudyCommand command_ = study_command<Tilt>(
      "tilt", "",
      [](Tilt& a) -> std::vector<CommandOption> {
        return {{"--out", &a.folder, ""},
                {.name = "--check", .target = &a.page, .help = "", .instead_of = "--out"},
                {.name = "--angle", .target = &a.angle, .help = "", .positive = true},
                {.name = "--step", .target = &a.steps, .help = "", .range = {{3, 6}}},
                {"--quick", &a.quick, ""}};
      },
      [this](const Tilt& a, const Surroundings&) {
        seen_ = a;
        if (a.angle == 90) throw dda::InputError("", "--angle", "90", "less");
        if (a.angle == 91) throw std::runtime_error("over");
        return a.quick ? 1 : 0;
      });
};

TEST_F(TiltProgram, ReadsItsOptions) {
  EXPECT_EQ(run({"--out", "there", "--step", "3", "--step", "6", "--quick"}), 1);
  EXPECT_EQ(seen_.folder, "there");
  EXPECT_EQ(seen_.steps, (std::vector<int>{3, 6}));
  EXPECT_EQ(seen_.angle, 3);
}

TEST_F(TiltProgram, RefusesWhatIsWrongWithCode2) {
  using Words = std::vector<const char*>;
  for (const Words& words : {Words{}, Words{"--out", "a", "--check", "b"}, Words{"--out", "a", "--angle", "0"},
                             Words{"--out", "a", "--step", "7"}, Words{"--out", ""}, Words{"--out", "a", "--no"}}) {
    EXPECT_EQ(run(words), 2);
    EXPECT_EQ(errors_.str().rfind("tilt: ", 0), 0U) << errors_.str();
  }
}

TEST_F(TiltProgram, TellsBadInputFromOtherErrors) {
  EXPECT_EQ(run({"--check", "a", "--angle", "90"}), 2);
  EXPECT_EQ(run({"--check", "a", "--angle", "91"}), 1);
  EXPECT_EQ(errors_.str(), "tilt: over\n");
}

}  // namespace
}  // namespace verify
