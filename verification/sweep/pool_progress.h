// How far a sweep is, for the terminal.
#pragma once

#include <chrono>
#include <cstddef>
#include <iosfwd>

namespace verify {

// One line that is drawn over after every job: ended, failed, time left at that pace. No output: does nothing.
class PoolProgress {
 public:
  PoolProgress(std::size_t jobs, std::ostream* output);
  ~PoolProgress();  // ends the line
  PoolProgress(const PoolProgress&) = delete;
  PoolProgress& operator=(const PoolProgress&) = delete;

  void job_ended(bool failed);

 private:
  void draw();

  std::size_t jobs_;
  std::size_t ended_ = 0;
  std::size_t failed_ = 0;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  std::ostream* output_;
};

}  // namespace verify
