#include "verification/precision/study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "engine/core/error.h"
#include "engine/core/temporary_folder.h"
#include "verification/precision/grid.h"
#include "verification/precision/other_systems.h"
#include "verification/precision/summary.h"
#include "verification/precision/table.h"

namespace verify {
namespace {

class Study : public testing::Test {
 protected:
  [[nodiscard]] std::vector<Measured> run(int rounds, bool resume) const {
    return run_study(jobs_, folder_, {rounds, resume, nullptr});
  }
  [[nodiscard]] std::vector<std::string> lines() const {
    std::vector<std::string> all;
    std::ifstream stream(folder_ / "runs.jsonl");
    for (std::string line; std::getline(stream, line);)
      if (!line.empty()) all.push_back(line);
    return all;
  }

  dda::TemporaryFolder place_;
  std::filesystem::path folder_ = place_ / "study";
  std::vector<PrecisionJob> jobs_ = {{Problem::bar, accurate_scheme(Problem::bar), 10, 2e-4},
                                     {Problem::bar, thesis_scheme(), 10, 2e-4},
                                     {Problem::bar, {"no such law", "trapezoidal"}, 10, 2e-4}};
};

TEST_F(Study, RunsInTurnAndKeepsTheLeastTime) {
  const std::vector<Measured> all = run(2, false);
  const std::vector<std::string> written = lines();
  ASSERT_EQ(written.size(), 6U);
  EXPECT_EQ(written[0].substr(0, 60), written[3].substr(0, 60));
  EXPECT_NE(written[0].substr(0, 60), written[1].substr(0, 60));
  EXPECT_EQ(all[0].runs, 2);
  const auto time_of = [](const std::string& line) { return std::stod(line.substr(line.find("\"cpu_s\":") + 8)); };
  EXPECT_DOUBLE_EQ(all[0].result.cpu_s, std::min(time_of(written[0]), time_of(written[3])));
  EXPECT_LT(all[0].result.error, all[1].result.error);
  EXPECT_EQ(all[0].failure, "");
  EXPECT_NE(all[2].failure.find("no such law"), std::string::npos);
}

TEST_F(Study, ResumesAfterALineCutOff) {
  const std::vector<Measured> whole = run(1, false);
  const std::vector<std::string> written = lines();
  std::ofstream(folder_ / "runs.jsonl") << written[0] << "\n" << written[1].substr(0, 50);
  const std::vector<Measured> all = run(1, true);
  EXPECT_EQ(lines().size(), 4U);  // the first, the cut one, and two new ones
  EXPECT_EQ(all[0].runs, 1);
  EXPECT_EQ(all[0].result.cpu_s, whole[0].result.cpu_s);  // read, not run
  EXPECT_EQ(all[1].result.error, whole[1].result.error);
  (void)run(1, true);
  EXPECT_EQ(lines().size(), 4U);
}

TEST_F(Study, EarlierRunsAreNotThrownAway) {
  (void)run(1, false);
  EXPECT_THROW((void)run(1, false), dda::InputError);
  EXPECT_EQ(lines().size(), 3U);
}

Measured made_up(const PrecisionScheme& scheme, double size, int cells, double error, double cpu_s) {
  Measured measured;
  measured.job = {Problem::bar, scheme, size, 1e-4};
  measured.result = {error, error / 2, cells, 10, 10, 0, cpu_s};
  measured.runs = 1;
  return measured;
}

TEST(Summary, ComparesTheCheapestRuns) {
  const std::vector<Measured> all = {made_up(thesis_scheme(), 1, 4000, 0.009, 8.0),
                                     made_up(thesis_scheme(), 2, 2000, 0.02, 4.0),
                                     made_up(accurate_scheme(Problem::bar), 1, 100, 0.001, 0.4),
                                     made_up(accurate_scheme(Problem::bar), 2, 50, 0.01, 0.1)};
  EXPECT_DOUBLE_EQ(*gain(all, Problem::bar, Cost::cpu, Norm::l2, 0.01), 80);
  EXPECT_DOUBLE_EQ(*gain(all, Problem::bar, Cost::passes, Norm::l2, 0.01), 80);
  EXPECT_DOUBLE_EQ(*gain(all, Problem::bar, Cost::cpu, Norm::reading, 0.01), 40);
  EXPECT_FALSE(gain(all, Problem::bar, Cost::cpu, Norm::l2, 0.003));
  const std::string csv = to_csv(all);
  EXPECT_NE(csv.find(",8,1,false,false\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",0.4,1,true,true\n"), std::string::npos) << csv;
}

// Names of schemes hold no commas: every row has the columns of the head.
TEST(Table, IsAsWideInEveryRow) {
  std::vector<Measured> all;
  for (const Problem problem : {Problem::bar, Problem::plane})
    for (const PrecisionScheme& scheme : study_schemes(problem)) all.push_back(made_up(scheme, 1, 10, 0.1, 1));
  std::istringstream rows(to_csv(all));
  std::string row;
  std::getline(rows, row);
  const auto commas = std::count(row.begin(), row.end(), ',');
  while (std::getline(rows, row)) EXPECT_EQ(std::count(row.begin(), row.end(), ','), commas) << row;
}

TEST(OtherSystems, AreReadAndMistakesNamed) {
  const dda::TemporaryFolder folder;
  const std::filesystem::path file = folder / "other_systems.csv";
  const std::string head = "problem,law,integrator,size_m,dt_s,cells,steps,error,reading_error,cpu_s\n";
  std::ofstream(file) << head << "bar,Program,rule,2.5,1e-4,40,281,0.05,0.01,0.7\n";
  const std::vector<Measured> read = read_other_systems(file);
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].result.cpu_s, 0.7);
  EXPECT_EQ(read[0].job.size, 2.5);
  EXPECT_TRUE(engine_runs(read, Problem::bar).empty());
  EXPECT_EQ(runs_of(read, Problem::bar).size(), 1U);
  for (const char* wrong : {"bar,Program,rule,2.5", "moon,Program,rule,2.5,1e-4,40,281,0.05,0.01,0.7",
                            "bar,Program,rule,x,1e-4,40,281,0.05,0.01,0.7"}) {
    std::ofstream(file) << head << wrong << "\n";
    EXPECT_THROW((void)read_other_systems(file), std::runtime_error) << wrong;
  }
  std::filesystem::remove(file);
  EXPECT_TRUE(read_other_systems(file).empty());
}

}  // namespace
}  // namespace verify
