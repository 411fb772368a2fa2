#include "verification/sweep/process_pool.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <map>

namespace verify {
namespace {

constexpr int not_started = 127;  // what a shell, too, says of a program it cannot find

[[noreturn]] void become(const std::vector<char*>& arguments, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(not_started);  // it had ended before the line above
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) ::dup2(nowhere, STDOUT_FILENO);
  ::execvp(arguments.front(), arguments.data());
  ::_exit(not_started);
}

// The new process, or -1.
pid_t start(Command command) {
  std::vector<char*> arguments;
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child == 0) become(arguments, parent);
  return child;
}

std::string failure_of(int status) {
  if (WIFSIGNALED(status)) return fmt::format("signal {} ({})", WTERMSIG(status), ::strsignal(WTERMSIG(status)));
  if (WEXITSTATUS(status) == not_started) return "could not be started";
  return WEXITSTATUS(status) == 0 ? "" : fmt::format("exit code {}", WEXITSTATUS(status));
}

class Running {
 public:
  explicit Running(const OnEnd& on_end) : on_end_(on_end) {}

  [[nodiscard]] std::size_t size() const { return tasks_.size(); }

  void add(const PoolTask& task) {
    const pid_t child = start(task.command);
    if (child < 0) {
      on_end_(task.index, "could not be started");
    } else {
      tasks_[child] = task.index;
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
    on_end_(index, failure_of(status));
  }

 private:
  const OnEnd& on_end_;
  std::map<pid_t, std::size_t> tasks_;
};

}  // namespace

void run_processes(const std::vector<PoolTask>& tasks, int at_once, const OnEnd& on_end) {
  const auto limit = static_cast<std::size_t>(std::max(1, at_once));
  Running running(on_end);
  for (const PoolTask& task : tasks) {
    while (running.size() >= limit) running.wait_for_one();
    running.add(task);
  }
  while (running.size() > 0) running.wait_for_one();
}

}  // namespace verify
