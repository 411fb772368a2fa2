#include "verification/sweep/pool_progress.h"

#include <fmt/format.h>

#include <ostream>

#include "engine/record/progress.h"

namespace verify {

PoolProgress::PoolProgress(std::size_t jobs, std::ostream* output) : jobs_(jobs), output_(output) {
  if (jobs_ == 0) output_ = nullptr;
  draw();
}

PoolProgress::~PoolProgress() {
  if (output_ != nullptr) *output_ << std::endl;
}

void PoolProgress::job_ended(bool failed) {
  ++ended_;
  if (failed) ++failed_;
  draw();
}

void PoolProgress::draw() {
  if (output_ == nullptr) return;
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - began_;
  const double left =
      ended_ == 0 ? -1 : spent.count() * static_cast<double>(jobs_ - ended_) / static_cast<double>(ended_);
  *output_ << fmt::format("\r{} of {} jobs{}, {} left \x1b[K", ended_, jobs_,
                          failed_ == 0 ? "" : fmt::format(", {} failed", failed_), dda::clock_text(left))
           << std::flush;
}

}  // namespace verify
