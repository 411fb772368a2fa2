#include "verification/study/process_pool.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <iostream>
#include <map>
#include <utility>

namespace verify {
namespace {

constexpr int not_started = 127;  // what a shell, too, says of a program it cannot find

// What the new process does; it ends with an exit code.
using Act = std::function<int()>;

void drop_standard_output() {
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) ::dup2(nowhere, STDOUT_FILENO);
}

int become(const PoolTask& task) {
  std::vector<std::string> words = task.command;
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  drop_standard_output();
  if (task.folder.empty() || ::chdir(task.folder.c_str()) == 0) ::execvp(arguments.front(), arguments.data());
  return not_started;
}

int act_as_copy(const std::function<void(std::size_t)>& act, std::size_t index) {
  try {
    act(index);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << fmt::format("job {}: {}\n", index, error.what()) << std::flush;
    return 1;
  }
}

// The new process, or -1.
pid_t start(const Act& act) {
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child != 0) return child;
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(not_started);  // it had ended before the line above
  ::_exit(act());
}

std::string phrase_for(int status) {
  if (WIFSIGNALED(status)) return fmt::format("signal {} ({})", WTERMSIG(status), ::strsignal(WTERMSIG(status)));
  if (WEXITSTATUS(status) == not_started) return "could not be started";
  return WEXITSTATUS(status) == 0 ? "" : fmt::format("exit code {}", WEXITSTATUS(status));
}

class Running {
 public:
  explicit Running(const OnEnd& on_end) : on_end_(on_end) {}

  [[nodiscard]] std::size_t size() const { return tasks_.size(); }

  void add(std::size_t index, const Act& act) {
    const pid_t child = start(act);
    if (child < 0) {
      on_end_(index, "could not be started");
    } else {
      tasks_[child] = index;
    }
  }

  void wait_for_one() {
    int status = 0;
    const pid_t child = ::waitpid(-1, &status, 0);
    if (child < 0 && errno == EINTR) return;
    const auto ended = tasks_.find(child);
    if (ended == tasks_.end()) return;  // not one of ours
    const std::size_t index = ended->second;
    tasks_.erase(ended);
    on_end_(index, phrase_for(status));
  }

 private:
  const OnEnd& on_end_;
  std::map<pid_t, std::size_t> tasks_;
};

// `acts` in their order, each with its index.
void run_all(const std::vector<std::pair<std::size_t, Act>>& acts, int at_once, const OnEnd& on_end) {
  const auto limit = static_cast<std::size_t>(std::max(1, at_once));
  Running running(on_end);
  for (const auto& [index, act] : acts) {
    while (running.size() >= limit) running.wait_for_one();
    running.add(index, act);
  }
  while (running.size() > 0) running.wait_for_one();
}

}  // namespace

void run_processes(const std::vector<PoolTask>& tasks, int at_once, const OnEnd& on_end) {
  std::vector<std::pair<std::size_t, Act>> acts;
  for (const PoolTask& task : tasks) acts.emplace_back(task.index, [&task] { return become(task); });
  run_all(acts, at_once, on_end);
}

void run_copies(std::size_t count, int at_once, const std::function<void(std::size_t index)>& act,
                const OnEnd& on_end) {
  std::vector<std::pair<std::size_t, Act>> acts;
  for (std::size_t i = 0; i < count; ++i) acts.emplace_back(i, [&act, i] { return act_as_copy(act, i); });
  run_all(acts, at_once, on_end);
}

std::string failure_of(const Command& command, const std::filesystem::path& folder) {
  std::string how;
  run_processes({{0, command, folder}}, 1, [&](std::size_t, const std::string& failure) { how = failure; });
  return how;
}

}  // namespace verify
