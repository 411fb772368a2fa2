#include "engine/core/phase_clock.h"

#include <chrono>

namespace dda {
namespace {

std::size_t at(Phase phase) { return static_cast<std::size_t>(phase); }

}  // namespace

std::int64_t PhaseClock::steady_now() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

PhaseClock::PhaseClock(Now now) : now_(now), start_(now()), last_change_(start_) {
  open_.push_back({Phase::other, start_});
  costs_[at(Phase::other)].calls = 1;
  running = this;
}

std::int64_t PhaseClock::book() {
  const std::int64_t now = now_();
  costs_[at(open_.back().phase)].nanoseconds += now - last_change_;
  last_change_ = now;
  return now;
}

void PhaseClock::enter(Phase phase) {
  const std::int64_t now = book();
  open_.push_back({phase, now});
  ++costs_[at(phase)].calls;
}

void PhaseClock::leave() {
  const std::int64_t now = book();
  const Open ended = open_.back();
  open_.pop_back();
  if (events_.size() < most_events) {
    events_.push_back({ended.phase, ended.begin - start_, now - ended.begin});
  } else {
    ++events_left_out_;
  }
}

std::array<PhaseCost, phase_names.size()> PhaseClock::costs() const {
  auto costs = costs_;
  costs[at(open_.back().phase)].nanoseconds += now_() - last_change_;
  return costs;
}

}  // namespace dda
