// The program itself, as a process: stopping it and going on.
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>
#include <vector>

#include "engine/app/app_test_support.h"

namespace dda {
namespace {

class Program : public FolderTest {
 protected:
  pid_t start(const std::vector<std::string>& arguments) { return start(arguments, path("stderr")); }

  pid_t start(std::vector<std::string> arguments, const std::string& errors) {
    std::string program = DDA_PROGRAM;
    std::vector<char*> argv = {program.data()};
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    const std::string out = path("stdout");
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    pid_t process = 0;
    EXPECT_EQ(posix_spawn(&process, DDA_PROGRAM, &files, nullptr, argv.data(), environ), 0);
    posix_spawn_file_actions_destroy(&files);
    return process;
  }

  // The exit code, or minus the signal that ended it.
  static int end_of(pid_t process) {
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  // Sends `number` once the run is under way: rows are being written, and there is a checkpoint.
  int interrupt(const std::vector<std::string>& arguments, int number) { return interrupt(start(arguments), number); }

  int interrupt(pid_t process, int number) {
    const auto under_way = [&] { return exists("out/histories.csv.tmp") && exists("out/checkpoint.bin"); };
    for (int i = 0; i < 10000 && !under_way(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ::kill(process, number);
    return end_of(process);
  }

  std::vector<std::string> run_into(const std::string& folder) {
    return {"run", path("scene.json"), "--out", path(folder), "--frames", "5", "--every", "7"};
  }

  void expect_results_as_of_one_run() {
    ASSERT_EQ(end_of(start(run_into("whole"))), 0);
    auto whole = files_below("whole");
    auto pieces = files_below("out");
    for (auto* files : {&whole, &pieces}) {
      const auto summary = nlohmann::json::parse((*files)["summary.json"]);
      EXPECT_EQ(summary["status"], "ok");
      // They hold run times, and counters of the factorization that resuming needs.
      files->erase("summary.json");
      files->erase("checkpoint.bin");
    }
    EXPECT_EQ(whole.size(), 3U + 2 * (1U + 6U));
    ASSERT_EQ(whole.size(), pieces.size());
    for (const auto& [name, content] : whole) EXPECT_TRUE(pieces[name] == content) << name << " differs";
  }
};

// A run that lasts long enough to be met half-way, twice: 0.1 s and more.
const std::string long_bar = bar_scene(100, 15000);

TEST_F(Program, StopsInOrderAndGoesOnToTheSameResults) {
  write("scene.json", long_bar);
  ASSERT_EQ(interrupt(run_into("out"), SIGINT), 128 + SIGINT);
  EXPECT_EQ(text("stderr"), "");
  const auto summary = nlohmann::json::parse(text("out/summary.json"));
  EXPECT_EQ(summary["status"], "stopped");
  const auto steps = summary["steps"].get<std::int64_t>();
  EXPECT_GT(steps, 0);
  EXPECT_LT(steps, 15000);
  EXPECT_FALSE(exists("out/histories.csv.tmp"));
  const std::string rows = text("out/histories.csv");
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 2 + steps / 7);

  std::vector<std::string> resume = run_into("out");
  resume.emplace_back("--resume");
  ASSERT_EQ(interrupt(resume, SIGTERM), 128 + SIGTERM) << text("stderr");
  ASSERT_EQ(end_of(start(resume)), 0) << text("stderr");
  expect_results_as_of_one_run();
}

TEST_F(Program, SaysOnATerminalThatItHasHeard) {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(terminal, 0);
  ASSERT_EQ(grantpt(terminal), 0);
  ASSERT_EQ(unlockpt(terminal), 0);
  write("scene.json", long_bar);
  // Held open, or what the run has written would go with it.
  const int held = open(ptsname(terminal), O_RDWR | O_NOCTTY);
  ASSERT_EQ(interrupt(start(run_into("out"), ptsname(terminal)), SIGINT), 128 + SIGINT);
  std::string said(4096, '\0');
  said.resize(static_cast<std::size_t>(std::max<ssize_t>(read(terminal, said.data(), said.size()), 0)));
  EXPECT_NE(said.find("stops at the end of this step"), std::string::npos) << said;
  close(held);
  close(terminal);
}

TEST_F(Program, GoesOnAfterBeingKilled) {
  write("scene.json", long_bar);
  ASSERT_EQ(interrupt(run_into("out"), SIGKILL), -SIGKILL);
  EXPECT_FALSE(exists("out/summary.json"));
  std::vector<std::string> resume = run_into("out");
  resume.emplace_back("--resume");
  ASSERT_EQ(end_of(start(resume)), 0) << text("stderr");
  expect_results_as_of_one_run();
}

TEST_F(Program, DrawsNoBarWhereThereIsNoTerminal) {
  write("scene.json", bar_scene(3, 100));
  EXPECT_EQ(end_of(start(run_into("out"))), 0);
  EXPECT_EQ(text("stderr"), "");
}

TEST_F(Program, ExitCodesReachTheShell) {
  EXPECT_EQ(end_of(start({"check", path("none.json")})), 2);
  const std::string sentence = text("stderr");
  EXPECT_EQ(std::count(sentence.begin(), sentence.end(), '\n'), 1) << sentence;
  EXPECT_EQ(text("stdout"), "");
  write("scene.json", falling_stone);
  EXPECT_EQ(end_of(start(run_into("out"))), 3);
  EXPECT_EQ(end_of(start({"--help"})), 0);
}

}  // namespace
}  // namespace dda
