#include "engine/core/parallel.h"

#include <sched.h>

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

namespace dda {
namespace {

void pause_briefly() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

// Looks again and again for a while, then sleeps: between the products of an iteration there are microseconds, and
// waking a thread takes ten.
template <typename Value>
void wait_while(const std::atomic<Value>& value, Value old) {
  constexpr int looks = 1000;
  for (int i = 0; i < looks; ++i) {
    if (value.load(std::memory_order_acquire) != old) return;
    pause_briefly();
  }
  value.wait(old, std::memory_order_acquire);
}

// The pieces of a job that a thread begins with: the same share of every job, so that what it reads and writes is what
// lies in its processor's cache since the last one.
struct alignas(64) Share {
  std::atomic<std::size_t> next{0};
  std::size_t end = 0;
};

// One job at a time. Whoever is done with its own pieces takes those of the others: where the other threads get no
// processor the caller does all of the job.
class Pool {
 public:
  ~Pool() { set_threads(1); }

  void set_threads(int threads) {
    if (threads == threads_) return;
    stopped_ = true;
    announce();
    workers_.clear();  // joins
    shares_.clear();
    stopped_ = false;
    threads_ = threads;
  }

  [[nodiscard]] int threads() const { return threads_.load(std::memory_order_relaxed); }

  void run(std::size_t count, PieceOfWork work, const void* body) {
    if (busy_.exchange(true, std::memory_order_acquire)) {
      for (std::size_t i = 0; i < count; ++i) work(body, i);
      return;
    }
    start_workers();
    work_ = work;
    body_ = body;
    for (std::size_t i = 0; i < shares_.size(); ++i) {
      shares_[i].next.store(i * count / shares_.size(), std::memory_order_relaxed);
      shares_[i].end = (i + 1) * count / shares_.size();
    }
    is_open_ = true;
    announce();
    take_pieces(0);
    is_open_ = false;
    for (int inside = inside_; inside != 0; inside = inside_) wait_while(inside_, inside);
    busy_.store(false, std::memory_order_release);
  }

 private:
  void announce() {
    ++jobs_;
    jobs_.notify_all();
  }

  void start_workers() {
    const auto threads = static_cast<std::size_t>(this->threads());
    if (shares_.size() == threads) return;
    shares_ = std::vector<Share>(threads);
    for (std::size_t own = 1; own < threads; ++own)
      workers_.emplace_back([this, own, seen = jobs_.load()] { serve(own, seen); });
  }

  void serve(std::size_t own, std::uint32_t seen) {
    while (!stopped_) {
      wait_while(jobs_, seen);
      seen = jobs_;
      // Either the caller sees that someone is inside, or the job is seen to be closed: both are sequentially
      // consistent.
      ++inside_;
      if (is_open_) take_pieces(own);
      --inside_;
      inside_.notify_one();
    }
  }

  void take_pieces(std::size_t own) {
    for (std::size_t other = 0; other < shares_.size(); ++other) {
      Share& share = shares_[(own + other) % shares_.size()];
      for (std::size_t i = share.next++; i < share.end; i = share.next++) work_(body_, i);
    }
  }

  std::atomic<int> threads_{1};
  std::atomic<bool> busy_{false};  // by a job, from its caller's arrival to its end

  PieceOfWork work_ = nullptr;
  const void* body_ = nullptr;
  std::vector<Share> shares_;           // one a thread, the caller's first
  std::atomic<bool> is_open_{false};    // the three above may be read
  std::atomic<int> inside_{0};          // workers that may be reading them
  std::atomic<std::uint32_t> jobs_{0};  // announced
  std::atomic<bool> stopped_{false};
  std::vector<std::jthread> workers_;
};

Pool& pool() {
  static Pool the_pool;
  return the_pool;
}

}  // namespace

int cores() {
  cpu_set_t allowed;
  return sched_getaffinity(0, sizeof allowed, &allowed) == 0 ? CPU_COUNT(&allowed) : 1;
}

void use_threads(int threads) { pool().set_threads(threads); }
int threads_in_use() { return pool().threads(); }
void share_out(std::size_t count, PieceOfWork work, const void* body) { pool().run(count, work, body); }

}  // namespace dda
