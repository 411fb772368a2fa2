// When a support of the rock that was put in is taken out again, and how.
#pragma once

#include <cstddef>
#include <optional>

#include "engine/model/time_function.h"

namespace dda {

struct Withdrawal {
  int last_stage = -1;  // taken out at the start of the stage after this one; -1: never
  // Factor, over the time since then, on what it exerted until then, which goes on acting as a load. None: that goes at
  // once.
  std::optional<TimeFunction> relaxation;

  [[nodiscard]] bool is_at_start_of(std::size_t stage) const {
    return last_stage >= 0 && static_cast<std::size_t>(last_stage) + 1 == stage;
  }
  // By the time that `stage` is under way.
  [[nodiscard]] bool is_over_in(std::size_t stage) const {
    return last_stage >= 0 && static_cast<std::size_t>(last_stage) < stage;
  }
};

}  // namespace dda
