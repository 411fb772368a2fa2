// Folder, processes, lists and table of a sweep. Jobs are run by shell scripts in place of the program.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/core/temporary_folder.h"
#include "verification/study/process_pool.h"
#include "verification/sweep/job.h"
#include "verification/sweep/job_list.h"
#include "verification/sweep/sweep_command.h"
#include "verification/sweep/sweep_folder.h"
#include "verification/sweep/sweep_test_support.h"
#include "verification/sweep/table.h"

namespace verify {
namespace {

TEST(ProcessPool, TellsHowEachEnded) {
  std::vector<std::string> ends(4);
  run_processes({{0, {"true"}}, {1, {"sh", "-c", "exit 3"}}, {2, {"sh", "-c", "kill -9 $$"}}, {3, {"/no/such"}}}, 2,
                [&](std::size_t index, const std::string& failure) { ends[index] = failure; });
  EXPECT_EQ(ends[0], "");
  EXPECT_EQ(ends[1], "exit code 3");
  EXPECT_EQ(ends[2], "signal 9 (Killed)");
  EXPECT_EQ(ends[3], "could not be started");
}

// Each process notes itself and looks how many others are at work.
TEST(ProcessPool, RunsSoManyAtOnceAndNoMore) {
  for (const int at_once : {1, 3}) {
    const dda::TemporaryFolder folder;
    const std::string dir = folder.path().string();
    const Command command = {"sh", "-c",
                             "cd " + dir + "; touch run.$$; ls | grep -c ^run >> seen; sleep 0.2; rm run.$$"};
    run_processes({{0, command}, {1, command}, {2, command}, {3, command}, {4, command}}, at_once, [](auto, auto&) {});
    std::istringstream seen(dda::read_file(folder.path() / "seen"));
    int most = 0, ended = 0;
    for (int count = 0; seen >> count; ++ended) most = std::max(most, count);
    EXPECT_EQ(ended, 5);
    EXPECT_LE(most, at_once);
    EXPECT_GT(most, at_once > 1 ? 1 : 0);
  }
}

TEST(JobList, WordsComeBackFromAShell) {
  EXPECT_EQ(shell_word("/a/b-1.json"), "/a/b-1.json");
  EXPECT_EQ(shell_word("my file"), "'my file'");
  EXPECT_EQ(shell_word("it's $x"), "'it'\\''s $x'");
  EXPECT_EQ(shell_word(""), "''");
}

class Sweep : public testing::Test {
 protected:
  Sweep() {
    std::ofstream(file()) << three_jobs;
    std::ofstream(program()) << "#!/bin/sh\n"
                                "echo $3 >> \"$5/started\"\nif [ $3 = 1 ]; then exit 7; fi\n";
    std::filesystem::permissions(program(), std::filesystem::perms::owner_all);
  }

  [[nodiscard]] std::filesystem::path file() const { return temporary_.path() / "spec.json"; }
  [[nodiscard]] std::filesystem::path program() const { return temporary_.path() / "program"; }
  [[nodiscard]] std::filesystem::path out() const { return temporary_.path() / "out"; }
  [[nodiscard]] std::string started() const { return dda::read_file(out() / "started"); }
  [[nodiscard]] SweepSpec spec() const { return read_spec(file()); }

  int run_job(std::size_t index) { return job({file(), index, out()}, said_); }

  int run(bool resume, bool list = false) {
    std::ostringstream said;
    errors_.str("");
    return sweep({file(), out(), 1, resume, list}, program(), said, errors_);
  }

  dda::TemporaryFolder temporary_;
  std::ostringstream said_, errors_;
};

TEST_F(Sweep, AJobThatDiesIsARowThatSaysWhy) {
  EXPECT_EQ(run(false), 1);
  EXPECT_EQ(started(), "0\n1\n2\n");
  EXPECT_NE(errors_.str().find("job 1 crashed: ended by exit code 7\n"), std::string::npos);
  EXPECT_NE(errors_.str().find("job 0 crashed: ended without a result\n"), std::string::npos);
  const std::string csv = dda::read_file(out() / "results.csv");
  EXPECT_NE(csv.find("\n1,crashed,ended by exit code 7,0.23"), std::string::npos);
}

TEST_F(Sweep, ResumingRunsWhatHasNotEnded) {
  EXPECT_EQ(run(false), 1);
  EXPECT_EQ(run_job(0), 0);
  EXPECT_EQ(run_job(2), 0);
  std::filesystem::remove(out() / "started");
  EXPECT_EQ(run(true), 1);
  EXPECT_EQ(started(), "1\n");
  EXPECT_EQ(run_job(1), 0);
  EXPECT_EQ(run(true), 0);
  EXPECT_EQ(started(), "1\n");
}

TEST_F(Sweep, ResumingRunsJobsOfOtherParametersAgain) {
  EXPECT_EQ(run(false), 1);
  for (const std::size_t i : {0U, 1U, 2U}) EXPECT_EQ(run_job(i), 0);
  std::filesystem::remove(out() / "started");
  std::ofstream(file()) << R"({"grid": {"block_length": [10], "dt": [2e-4, 2.5e-4, 4e-3], "law": ["consistent"]}})";
  EXPECT_EQ(run(true), 1);
  EXPECT_EQ(started(), "1\n");
}

TEST_F(Sweep, JobsOfAnEarlierSweepAreNotThrownAway) {
  EXPECT_EQ(run(false), 1);
  const std::string before = dda::read_file(SweepFolder(out()).job_file(1));
  for (const bool list : {false, true}) {
    try {
      static_cast<void>(run(false, list));
      FAIL() << "ran";
    } catch (const dda::InputError& error) {
      EXPECT_NE(std::string(error.what()).find(out().string()), std::string::npos);
      EXPECT_NE(error.expected().find("--resume"), std::string::npos);
    }
  }
  EXPECT_EQ(started(), "0\n1\n2\n");
  EXPECT_EQ(dda::read_file(SweepFolder(out()).job_file(1)), before);
}

TEST_F(Sweep, AJobSaysHowItEnded) {
  std::ofstream(file()) << R"({"grid": {"block_length": [10], "dt": [2e-4, 4e-3], "spring_over_young": [10, 1e30]}})";
  EXPECT_EQ(run_job(0), 0);
  EXPECT_EQ(run_job(2), 0) << "a job that cannot be measured has done what it could";
  EXPECT_EQ(run_job(1), 1) << "springs that overflow";
  std::string line;
  std::istringstream said(said_.str());
  std::getline(said, line);
  EXPECT_EQ(line, "job 0 ok");
  std::getline(said, line);
  EXPECT_TRUE(line.starts_with("job 2 not_measurable: time steps of")) << line;
  std::getline(said, line);
  EXPECT_TRUE(line.starts_with("job 1 failed: ")) << line;
  EXPECT_EQ(SweepFolder(out()).read(1, spec().jobs[1]).status, "failed");
}

// Tables count truths and plots draw numbers, and take neither for the other.
TEST_F(Sweep, AJobFileWithValuesOfAnotherKindIsNone) {
  static_cast<void>(run(false));
  const SweepFolder folder(out());
  const auto status_with = [&](const char* name, const nlohmann::ordered_json& value) {
    JobFile job{"ok", "", to_json(spec().jobs[0]), to_json(JobResult{})};
    job.result[name] = value;
    folder.write(0, job);
    const JobFile read = folder.read(0, spec().jobs[0]);
    EXPECT_FALSE(summary_of({read}).empty());
    return read.status;
  };
  EXPECT_EQ(status_with("velocity_agrees", true), "ok");
  EXPECT_EQ(status_with("velocity_agrees", nullptr), "missing");
  EXPECT_EQ(status_with("predicted_velocity_error_pct", nullptr), "ok");
  EXPECT_EQ(status_with("predicted_velocity_error_pct", 0.5), "ok");
  EXPECT_EQ(status_with("predicted_velocity_error_pct", "much"), "missing");
}

TEST_F(Sweep, HalfAJobFileIsNone) {
  static_cast<void>(run(false));
  EXPECT_EQ(run_job(0), 0);
  const SweepFolder folder(out());
  EXPECT_EQ(folder.read(0, spec().jobs[0]).status, "ok");
  const std::string text = dda::read_file(folder.job_file(0));
  std::ofstream(folder.job_file(0)) << text.substr(0, text.size() / 2);
  EXPECT_EQ(folder.read(0, spec().jobs[0]).status, "missing");
}

TEST_F(Sweep, TheTableHasARowAJobAndEveryColumnOfIt) {
  static_cast<void>(run(false));
  for (const std::size_t i : {0U, 1U, 2U}) EXPECT_EQ(run_job(i), 0);
  std::ostringstream said, errors;
  EXPECT_EQ(collect(out(), said, errors), 0);
  EXPECT_NE(said.str().find("3 jobs: 2 ok 1 not_measurable\n"), std::string::npos);
  std::istringstream csv(dda::read_file(out() / "results.csv"));
  std::string line;
  std::ptrdiff_t commas = 0;
  for (int row = -1; std::getline(csv, line); ++row) {
    if (row < 0) commas = std::count(line.begin(), line.end(), ',');
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), commas) << line;
  }
  EXPECT_GT(commas, 30);
}

TEST_F(Sweep, TheListHasTheOpenJobs) {
  EXPECT_EQ(run(false, true), 0);
  const std::string line = program().string() + " job " + (out() / "sweep.json").string() + " ";
  EXPECT_EQ(dda::read_file(out() / "jobs.txt"), line + "0 --out " + out().string() + "\n" + line + "1 --out " +
                                                    out().string() + "\n" + line + "2 --out " + out().string() + "\n");
  EXPECT_EQ(run_job(1), 0);
  EXPECT_EQ(run(true, true), 0);
  EXPECT_EQ(dda::read_file(out() / "jobs.txt").find(" 1 --out"), std::string::npos);
  EXPECT_NE(dda::read_file(out() / "slurm.sh").find("#SBATCH --array=1-2\n"), std::string::npos);
}

TEST_F(Sweep, TheListRefusesAFolderThatWouldSplitItsLines) {
  const SweepFolder folder(out() / "two\nlines");
  folder.prepare("{}");
  EXPECT_THROW(write_job_list(program(), folder, {0}), dda::InputError);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "jobs.txt"));
}

TEST_F(Sweep, BadSpecsLeaveNothingBehind) {
  std::ofstream(file()) << R"({"grid": {"eta": [2], "cfl": [1]}})";
  EXPECT_THROW(run(false), dda::InputError);
  EXPECT_FALSE(std::filesystem::exists(out()));
  EXPECT_THROW(static_cast<void>(run_job(0)), dda::InputError);
  EXPECT_FALSE(std::filesystem::exists(out()));
}

}  // namespace
}  // namespace verify
