// When the frames of a run are due.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/model/model.h"
#include "engine/record/summary.h"

namespace dda {

// Frames lie evenly over the time in which blocks move. A static stage that ends at equilibrium has no such time (its
// clock jumps to its end once forces balance): it gets one frame, at its end. Only where all stages are of that kind
// their time counts.
class FrameClock {
 public:
  // `interval`: s between frames, above 0.
  FrameClock(const Model& model, double interval);

  // At the end of a step, or at the start.
  [[nodiscard]] bool is_due(double time) const;

  // A frame of that time has been written.
  void taken(double time);

 private:
  [[nodiscard]] double moving_time(double time) const;
  [[nodiscard]] bool has_settled_at(double time) const;

  std::vector<StageTimes> settlings_;
  double interval_;
  std::int64_t next_ = 0;  // in intervals of moving time
};

// The stages of a scene, and which of them have no time in which blocks move.
[[nodiscard]] std::vector<StageTimes> stage_spans(const Model& model);

// The time over which frames are spread, s, of the stages from `first` on.
[[nodiscard]] double moving_time(const Model& model, std::size_t first = 0);

}  // namespace dda
