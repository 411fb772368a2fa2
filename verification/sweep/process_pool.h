// Runs commands as processes, so many at once.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace verify {

using Command = std::vector<std::string>;  // a program and its arguments

struct PoolTask {
  std::size_t index = 0;
  Command command;
};

// How a process ended: "" for exit code 0, else a phrase ("exit code 3", "signal 9 (Killed)", "could not be started").
using OnEnd = std::function<void(std::size_t index, const std::string& failure)>;

// Starts the tasks in their order, never more than `at_once` (at least 1) at a time, and returns when all have ended.
// Processes end with this one, however it ends. Standard output of the commands is dropped.
void run_processes(const std::vector<PoolTask>& tasks, int at_once, const OnEnd& on_end);

}  // namespace verify
