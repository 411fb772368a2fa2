#include "engine/app/frame_clock.h"

#include <algorithm>
#include <cmath>

namespace dda {
namespace {

constexpr double round_off = 1e-6;           // of an interval or a stage: steps end that close to where frames are due
constexpr double round_off_of_sums = 1e-12;  // of a time: stages may take none

bool settles(const Stage& stage) { return stage.integrator.is_static && stage.equilibrium > 0; }

bool stands_still(const Model& model, const Stage& stage) {
  return stage.paces_itself() || (settles(stage) && !std::ranges::all_of(model.stages, settles));
}

}  // namespace

std::vector<StageTimes> stage_spans(const Model& model) {
  std::vector<StageTimes> spans;
  double begin = 0;
  for (const Stage& stage : model.stages) {
    spans.push_back({stage.name, begin, begin + stage.length(), stands_still(model, stage), stage.shortest_dt(),
                     stage.dt, stage.chosen.dt.reason, stage.integrator.name, stage.chosen.integrator.reason});
    begin = spans.back().end_s;
  }
  return spans;
}

FrameClock::FrameClock(const Model& model, double interval) : settlings_(stage_spans(model)), interval_(interval) {
  std::erase_if(settlings_, [](const StageTimes& stage) { return !stage.settles; });
}

double FrameClock::moving_time(double time) const {
  double settling = 0;
  for (const StageTimes& stage : settlings_) settling += std::clamp(time, stage.begin_s, stage.end_s) - stage.begin_s;
  return time - settling;
}

bool FrameClock::has_settled_at(double time) const {
  return std::ranges::any_of(settlings_, [&](const StageTimes& stage) {
    return std::abs(time - stage.end_s) <= round_off * (stage.end_s - stage.begin_s) + round_off_of_sums * time;
  });
}

bool FrameClock::is_due(double time) const {
  return has_settled_at(time) || moving_time(time) / interval_ + round_off >= static_cast<double>(next_);
}

void FrameClock::taken(double time) {
  next_ = static_cast<std::int64_t>(moving_time(time) / interval_ + round_off) + 1;
}

double moving_time(const Model& model, std::size_t first) {
  double sum = 0;
  for (std::size_t i = first; i < model.stages.size(); ++i)
    if (!stands_still(model, model.stages[i])) sum += model.stages[i].length();
  return sum;
}

}  // namespace dda
