#include "engine/advice/shaking_remarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

#include "engine/advice/block_named.h"
#include "engine/model/held_motion.h"
#include "engine/model/stage_times.h"
#include "engine/simulation/acting_damping.h"

namespace dda {
namespace {

// A block that is moved, or places of it.
struct Moved {
  int block = 0;
  double size = 0;  // m or rad, m/s ..., by `kind`
  bool turns = false;
  MotionKind kind = MotionKind::displacement;
  const TimeFunction* history = nullptr;

  [[nodiscard]] const char* unit() const { return turns ? "rad" : "m"; }
};

std::vector<Moved> all_moved(const Model& model) {
  std::vector<Moved> all;
  for (const PointSupport& support : model.supports)
    if (!support.amplitude.isZero(0))
      all.push_back({support.block, support.amplitude.norm(), false, support.kind, &support.history});
  for (const HeldBlock& held : model.held_blocks) {
    const bool turns = held.amplitude.isZero(0);
    if (moves(held))
      all.push_back({held.block, turns ? std::abs(held.turn) : held.amplitude.norm(), turns, held.kind, &held.history});
  }
  return all;
}

// Sentences on motions of blocks; those that go on alike are one.
class Sentences {
 public:
  void add(int block, const std::string& rest) {
    const auto known = std::ranges::find(sentences_, rest, &Sentence::rest);
    if (known == sentences_.end())
      sentences_.push_back({rest, {block}});
    else if (std::ranges::find(known->blocks, block) == known->blocks.end())
      known->blocks.push_back(block);
  }

  [[nodiscard]] std::vector<std::string> of(const Model& model) const {
    std::vector<std::string> all;
    for (const Sentence& each : sentences_)
      all.push_back("the motion of " + blocks_named(model, each.blocks) + each.rest);
    return all;
  }

 private:
  struct Sentence {
    std::string rest;
    std::vector<int> blocks;
  };
  std::vector<Sentence> sentences_;
};

// The stage that this moment (s) is in, where it runs in time.
const Stage* stage_in_time(const Model& model, double time) {
  for (std::size_t i = 0; i < model.stages.size(); ++i)
    if (time < begin_of_stage(model, i + 1)) return model.stages[i].integrator.is_static ? nullptr : &model.stages[i];
  return nullptr;
}

// By how much displacements of a record change from one sample to the next at most: to begin or end by less is no jump
// of its own.
double largest_step(const Recording& recording) {
  double largest = 0;
  for (std::size_t i = 1; i < recording.values().size(); ++i)
    largest = std::max(largest, std::abs(recording.values()[i] - recording.values()[i - 1]));
  return largest;
}

void remark_on_jump_at_start(const Model& model, const Moved& moved, Sentences& sentences) {
  constexpr double round_off = 1e-12;
  const double value = std::abs(evaluate(*moved.history, 0));
  const auto* record = std::get_if<Recorded>(moved.history);
  const double least = record != nullptr ? largest_step(*record->recording) : round_off;
  if (value <= least || stage_in_time(model, 0) == nullptr) return;
  sentences.add(
      moved.block,
      fmt::format(" is {:.3g} {} at 0 s already, which it jumps to in the first step; let the history begin at "
                  "0, or let a static stage come first",
                  moved.size * value, moved.unit()));
}

void remark_on_jumps_of_record(const Model& model, const Moved& moved, const Recorded& record, Sentences& sentences) {
  const Recording& recording = *record.recording;
  const auto look_at = [&, start = record.start](double time, double value, const char* where) {
    if (time + start <= 0 || std::abs(value) <= largest_step(recording)) return;
    if (stage_in_time(model, time + start) == nullptr) return;
    sentences.add(moved.block,
                  fmt::format(" jumps by {:.3g} {} at {:g} s, {} sample of \"{}\": a record is zero "
                              "outside its samples",
                              moved.size * std::abs(value), moved.unit(), time + start, where, recording.name()));
  };
  look_at(recording.times().front(), recording.values().front(), "the first");
  look_at(recording.times().back(), recording.values().back(), "the last");
}

// The largest change of a record's slope at a sample within a span of the scene's clock (s).
double largest_kick(const Recorded& record, double from, double to) {
  const std::vector<double>& times = record.recording->times();
  double largest = 0;
  for (std::size_t i = 1; i + 1 < times.size(); ++i) {
    const double time = times[i] + record.start;
    if (time <= from || time >= to) continue;
    largest = std::max(largest, std::abs(record.recording->slope(times[i]) - record.recording->slope(times[i - 1])));
  }
  return largest;
}

void remark_on_kinks(const Model& model, const Moved& moved, const Recorded& record, Sentences& sentences) {
  constexpr double slack = 1 + 1e-6;  // times in files are rounded
  const Recording& recording = *record.recording;
  for (std::size_t i = 0; i < model.stages.size(); ++i) {
    const Stage& stage = model.stages[i];
    if (stage.integrator.is_static || slack * stage.dt >= recording.mean_interval()) continue;
    const double kick = moved.size * largest_kick(record, begin_of_stage(model, i), begin_of_stage(model, i + 1));
    if (kick == 0) continue;
    sentences.add(
        moved.block,
        fmt::format(" is of displacements, straight lines from sample to sample of \"{0}\", every {1:.3g} s: its "
                    "velocity jumps at each, by up to {2:.3g} {5}/s, which is {3:.3g} {5}/s2 for a step of stage "
                    "\"{4}\"; give its accelerations or velocities, or samples as close as dt",
                    recording.name(), recording.mean_interval(), kick, kick / stage.dt, stage.name, moved.unit()));
  }
}

struct Peaks {
  double velocity = 0, acceleration = 0;
};

// The largest over a span (s), without the impulses of kinks.
Peaks peaks_of(const Moved& moved, double from, double to) {
  constexpr int samples = 2000;
  Peaks peaks;
  for (int i = 0; i <= samples; ++i) {
    const MotionFactors motion = motion_at(moved.kind, *moved.history, from + (to - from) * i / samples);
    peaks.velocity = std::max(peaks.velocity, moved.size * std::abs(motion.velocity));
    peaks.acceleration = std::max(peaks.acceleration, moved.size * std::abs(motion.acceleration));
  }
  return peaks;
}

// 1/s. What takes a share of all velocities is damping in proportion to inertia as well.
double rate_of_braking(const Stage& stage) {
  return stage.integrator.is_static ? 0 : acting_damping(stage).mass + stage.damping_rate;
}

void remark_on_absolute_damping(const Model& model, const Moved& moved, Sentences& sentences) {
  for (std::size_t i = 0; i < model.stages.size(); ++i) {
    const double rate = rate_of_braking(model.stages[i]);
    const Peaks peaks = rate > 0 ? peaks_of(moved, begin_of_stage(model, i), begin_of_stage(model, i + 1)) : Peaks();
    if (peaks.velocity == 0) continue;
    const std::string beside = moved.kind == MotionKind::acceleration
                                   ? fmt::format(" (its own acceleration: {:.3g})", peaks.acceleration)
                                   : "";
    sentences.add(
        moved.block,
        fmt::format(" meets damping in proportion to inertia in stage \"{0}\": that brakes velocities against the "
                    "ground of 0 s, and not against what moves, so rock that only travels along is held back by "
                    "up to {1:.3g} {2}/s2{3}; damping of one \"frequency\" does not",
                    model.stages[i].name, rate * peaks.velocity, moved.unit(), beside));
  }
}

}  // namespace

std::vector<std::string> shaking_remarks(const Model& model) {
  Sentences sentences;
  for (const Moved& moved : all_moved(model)) {
    remark_on_absolute_damping(model, moved, sentences);
    if (moved.kind != MotionKind::displacement) continue;
    remark_on_jump_at_start(model, moved, sentences);
    if (const auto* record = std::get_if<Recorded>(moved.history)) {
      remark_on_jumps_of_record(model, moved, *record, sentences);
      remark_on_kinks(model, moved, *record, sentences);
    }
  }
  return sentences.of(model);
}

}  // namespace dda
