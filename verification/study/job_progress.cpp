#include "verification/study/job_progress.h"

#include <fmt/format.h>

#include <ostream>

#include "engine/record/progress.h"

namespace verify {

JobProgress::JobProgress(std::size_t jobs, std::ostream* output) : jobs_(jobs), output_(output) {
  if (jobs_ == 0) output_ = nullptr;
  draw();
}

JobProgress::~JobProgress() {
  if (output_ != nullptr) *output_ << std::endl;
}

void JobProgress::job_ended(bool failed) {
  ++ended_;
  if (failed) ++failed_;
  draw();
}

// Thousands of short jobs do not draw more often than an eye can follow.
void JobProgress::draw() {
  using namespace std::chrono_literals;
  const Clock::time_point now = Clock::now();
  if (output_ == nullptr || (ended_ > 0 && ended_ < jobs_ && now - drawn_ < 200ms)) return;
  drawn_ = now;
  const std::chrono::duration<double> spent = now - began_;
  const double left =
      ended_ == 0 ? -1 : spent.count() * static_cast<double>(jobs_ - ended_) / static_cast<double>(ended_);
  *output_ << fmt::format("\r{} of {} jobs{}, {} left \x1b[K", ended_, jobs_,
                          failed_ == 0 ? "" : fmt::format(", {} failed", failed_), dda::clock_text(left))
           << std::flush;
}

}  // namespace verify
