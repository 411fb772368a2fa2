// How far the jobs of a study are, for the terminal.
#pragma once

#include <chrono>
#include <cstddef>
#include <iosfwd>

namespace verify {

// One line that is drawn over as jobs end: ended, failed, time left at that pace. No output: does nothing.
class JobProgress {
 public:
  JobProgress(std::size_t jobs, std::ostream* output);
  ~JobProgress();  // ends the line
  JobProgress(const JobProgress&) = delete;
  JobProgress& operator=(const JobProgress&) = delete;

  void job_ended(bool failed = false);

 private:
  using Clock = std::chrono::steady_clock;
  void draw();

  std::size_t jobs_;
  std::size_t ended_ = 0;
  std::size_t failed_ = 0;
  Clock::time_point began_ = Clock::now();
  Clock::time_point drawn_;  // long ago, until it is drawn
  std::ostream* output_;
};

}  // namespace verify
