#include "engine/app/recording_report.h"
#include "engine/model/stage_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace dda {
namespace {

struct Use {
  Recorded recorded;
  bool is_load = true;
  MotionKind kind = MotionKind::displacement;
  double amplitude = 1;  // of a motion: m, m/s or m/s2
};

template <typename Motion>
void append_motion(const Motion& motion, std::vector<Use>& uses) {
  const auto* recorded = std::get_if<Recorded>(&motion.history);
  if (recorded != nullptr) uses.push_back({*recorded, false, motion.kind, motion.amplitude.norm()});
}

std::vector<Use> uses_of(const Model& model) {
  std::vector<Use> uses;
  const auto add_load = [&uses](const TimeFunction& history) {
    if (const auto* recorded = std::get_if<Recorded>(&history)) uses.push_back({*recorded});
  };
  for (const PointLoad& load : model.point_loads) add_load(load.history);
  for (const EdgeLoad& load : model.edge_loads) add_load(load.history);
  for (const PointSupport& support : model.supports) append_motion(support, uses);
  for (const HeldBlock& held : model.held_blocks) append_motion(held, uses);
  return uses;
}

std::string peak_of(const Use& use) {
  const Recording& recording = *use.recorded.recording;
  if (use.is_load) return fmt::format("peak {:.6g} times the load", recording.peak());
  const double peak = use.amplitude * recording.peak();
  switch (use.kind) {
    case MotionKind::displacement: return fmt::format("peak displacement {:.6g} m", peak);
    case MotionKind::velocity: return fmt::format("peak velocity {:.6g} m/s", peak);
    case MotionKind::acceleration: break;
  }
  const double end = std::max(0.0, recording.times().back() + use.recorded.start);
  const MotionFactors left = motion_at(use.kind, use.recorded, end);
  return fmt::format("peak acceleration {:.6g} m/s2; at its end velocity {:.3g} m/s, displacement {:.3g} m", peak,
                     use.amplitude * left.velocity, use.amplitude * left.displacement);
}

// A motion begins from rest at 0 s, and a load when the scene does.
std::string said_of_what_comes_before(const Use& use) {
  const double first = use.recorded.recording->times().front() + use.recorded.start;
  return first < 0 ? fmt::format("; its first {:.6g} s, before 0 s, do not act", -first) : "";
}

}  // namespace

std::vector<std::string> describe_recordings(const Model& model) {
  std::vector<std::string> lines;
  for (const Use& use : uses_of(model)) {
    const Recording& recording = *use.recorded.recording;
    std::string line =
        fmt::format("\"{}\": {} samples over {:.6g} s from {:.6g} s on, {}", recording.name(), recording.times().size(),
                    recording.duration(), recording.times().front() + use.recorded.start,
                    peak_of(use) + said_of_what_comes_before(use));
    if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<std::string> warn_of_recordings(const Model& model, std::size_t stage) {
  constexpr double slack = 1 + 1e-6;  // times in files are rounded
  const double begin = begin_of_stage(model, stage);
  const double dt = model.stages[stage].dt;
  std::set<std::string> lines;
  for (const Use& use : uses_of(model)) {
    const Recording& recording = *use.recorded.recording;
    const double first = recording.times().front() + use.recorded.start;
    const bool runs = first < begin + model.stages[stage].duration && first + recording.duration() > begin;
    if (!runs || dt <= slack * recording.mean_interval()) continue;
    lines.insert(fmt::format("warning: dt does not resolve \"{}\", which has a sample every {:.3g} s", recording.name(),
                             recording.mean_interval()));
  }
  return {lines.begin(), lines.end()};
}

}  // namespace dda
