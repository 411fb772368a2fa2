// Runs commands, or functions of this program, as processes, so many at once.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace verify {

using Command = std::vector<std::string>;  // a program and its arguments

struct PoolTask {
  std::size_t index = 0;
  Command command;
  std::filesystem::path folder = {};  // where it runs; empty: where this process does
};

// How a process ended: "" for exit code 0, else a phrase ("exit code 3", "signal 9 (Killed)", "could not be started").
using OnEnd = std::function<void(std::size_t index, const std::string& failure)>;

// Starts the tasks in their order, never more than `at_once` (at least 1) at a time, and returns when all have ended.
// Processes end with this one, however it ends. Standard output of the commands is dropped.
void run_processes(const std::vector<PoolTask>& tasks, int at_once, const OnEnd& on_end);

// The same with a copy of this process for each index below `count`, which acts and ends: with exit code 0, or with 1
// and a line on standard error if `act` throws. What it writes to memory is lost with it.
void run_copies(std::size_t count, int at_once, const std::function<void(std::size_t index)>& act, const OnEnd& on_end);

// Runs one command to its end and returns how it ended, as OnEnd is told.
[[nodiscard]] std::string failure_of(const Command& command, const std::filesystem::path& folder = {});

}  // namespace verify
