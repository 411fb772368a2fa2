// The verification catalogue: problems with an exact or published answer that suit a two-dimensional DDA engine, most
// fundamental first.
#pragma once

#include <string_view>
#include <vector>

namespace verify {

struct Problem {
  int number;
  std::string_view title;
};

// In the order of their numbers, from 1 without gaps.
[[nodiscard]] const std::vector<Problem>& catalogue();

}  // namespace verify
