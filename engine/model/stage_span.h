// The stages in which a load acts.
#pragma once

#include <cstddef>

namespace dda {

struct StageSpan {
  int first = 0;  // from the start of this stage on
  int last = -1;  // to the end of this one; -1: to the end of the run

  [[nodiscard]] bool has(std::size_t stage) const {
    return static_cast<std::size_t>(first) <= stage && !is_over_in(stage);
  }
  // By the time that `stage` is under way.
  [[nodiscard]] bool is_over_in(std::size_t stage) const { return last >= 0 && static_cast<std::size_t>(last) < stage; }
  [[nodiscard]] bool is_whole_run() const { return first == 0 && last == -1; }
};

}  // namespace dda
