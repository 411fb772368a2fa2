// Where a run is in its stages.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace dda {

// How loads and motions get to the end of a stage that paces itself: part by part, the next one when what the last one
// has put out of balance is at rest, or will not come to rest.
struct LoadParts {
  int all = 1;
  int gone = 0;    // by the loads as they are
  int waited = 0;  // steps since the last one that took a part
  bool waits = false;

  [[nodiscard]] double share() const { return static_cast<double>(gone) / all; }
  [[nodiscard]] double next_share() const { return static_cast<double>(next()) / all; }

  // A step was taken.
  void follow(bool is_at_rest) {
    constexpr int most_waited = 4;
    waited = gone == next() ? waited + 1 : 0;
    gone = next();
    waits = !is_at_rest && waited < most_waited;
  }

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [all, gone, waited, waits] = self;
    archive(all, gone, waited, waits);
  }

 private:
  [[nodiscard]] int next() const { return waits ? gone : std::min(all, gone + 1); }
};

struct StageClock {
  std::size_t stage = 0;
  bool begun = false;                   // else the run is between the stage before and this one, or over
  std::int64_t step = 0;                // in the stage
  double start = 0;                     // s, of the stage
  std::int64_t passes_before_step = 0;  // of the open-close iteration in the whole run, when the last step began
  LoadParts parts;                      // of the stage

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [stage, begun, step, start, passes_before_step, parts] = self;
    archive(stage, begun, step, start, passes_before_step, parts);
  }

  // The stage under way; between stages, and after the last, the one that ended.
  [[nodiscard]] std::size_t in_force() const { return begun || stage == 0 ? stage : stage - 1; }
};

}  // namespace dda
