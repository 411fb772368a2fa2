#include "dda/app/frame_clock.h"

#include <algorithm>
#include <cmath>

namespace dda {
namespace {

constexpr double round_off = 1e-6;  // of an interval or a stage: steps end that close to where frames are due

bool settles(const Stage& stage) { return stage.integrator.is_static && stage.equilibrium > 0; }

}  // namespace

bool stands_still(const Model& model, const Stage& stage) {
  return settles(stage) && !std::ranges::all_of(model.stages, settles);
}

FrameClock::FrameClock(const Model& model, double interval) : interval_(interval) {
  double begin = 0;
  for (const Stage& stage : model.stages) {
    if (stands_still(model, stage)) settlings_.push_back({begin, begin + stage.duration});
    begin += stage.duration;
  }
}

double FrameClock::moving_time(double time) const {
  double settling = 0;
  for (const Settling& stage : settlings_) settling += std::clamp(time, stage.begin, stage.end) - stage.begin;
  return time - settling;
}

bool FrameClock::has_settled_at(double time) const {
  return std::ranges::any_of(settlings_, [&](const Settling& stage) {
    return std::abs(time - stage.end) <= round_off * (stage.end - stage.begin);
  });
}

bool FrameClock::is_due(double time) const {
  return has_settled_at(time) || moving_time(time) / interval_ + round_off >= static_cast<double>(next_);
}

void FrameClock::taken(double time) {
  next_ = static_cast<std::int64_t>(moving_time(time) / interval_ + round_off) + 1;
}

double moving_time(const Model& model) {
  double sum = 0;
  for (const Stage& stage : model.stages)
    if (!stands_still(model, stage)) sum += stage.duration;
  return sum;
}

}  // namespace dda
