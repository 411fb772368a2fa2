// The jobs of a study: in this process one after the other, or so many at once, each in a copy of it.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace verify {

// What a job leaves is a text, as a copy of this process has nothing else to hand over.
using Job = std::function<std::string(std::size_t index)>;
using TakeText = std::function<void(std::size_t index, const std::string& text)>;

// Runs the jobs from 0 to `count` - 1. `take` gets their texts in the order of the indices, each as soon as it and all
// before it are there, so that a study says and writes the same however many run at once. Shows on the terminal how far
// it is. Throws what a job throws; std::runtime_error, after all others have ended, if one in a copy fails.
void run_jobs(std::size_t count, int at_once, const Job& job, const TakeText& take);

}  // namespace verify
