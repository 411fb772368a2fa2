#include "verification/study/jobs.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <stdexcept>

#include "engine/core/read_file.h"
#include "engine/core/temporary_folder.h"
#include "engine/record/atomic_file.h"
#include "engine/record/progress.h"
#include "verification/study/job_progress.h"
#include "verification/study/process_pool.h"

namespace verify {
namespace {

// Hands texts on in the order of their indices.
class InOrder {
 public:
  explicit InOrder(const TakeText& take) : take_(take) {}

  void add(std::size_t index, std::string text) {
    waiting_[index] = std::move(text);
    while (!waiting_.empty() && waiting_.begin()->first == next_) {
      take_(next_, waiting_.begin()->second);
      waiting_.erase(waiting_.begin());
      ++next_;
    }
  }

 private:
  const TakeText& take_;
  std::size_t next_ = 0;
  std::map<std::size_t, std::string> waiting_;
};

void run_side_by_side(std::size_t count, int at_once, const Job& job, InOrder& texts, JobProgress& progress) {
  const dda::TemporaryFolder folder;
  const auto file = [&](std::size_t index) { return folder.path() / std::to_string(index); };
  std::string first_failure;
  run_copies(
      count, at_once, [&](std::size_t index) { dda::write_file(file(index), job(index)); },
      [&](std::size_t index, const std::string& failure) {
        progress.job_ended(!failure.empty());
        if (failure.empty()) {
          texts.add(index, dda::read_file(file(index)));
          std::filesystem::remove(file(index));
        } else if (first_failure.empty()) {
          first_failure = fmt::format("job {} was ended by {}", index, failure);
        }
      });
  if (!first_failure.empty()) throw std::runtime_error(first_failure);
}

}  // namespace

void run_jobs(std::size_t count, int at_once, const Job& job, const TakeText& take) {
  JobProgress progress(count, dda::terminal());
  InOrder texts(take);
  if (at_once > 1) return run_side_by_side(count, at_once, job, texts, progress);
  for (std::size_t index = 0; index < count; ++index) {
    texts.add(index, job(index));
    progress.job_ended();
  }
}

}  // namespace verify
