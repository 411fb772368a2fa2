// Where a run is in its stages.
#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/simulation/load_parts.h"

namespace dda {

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
