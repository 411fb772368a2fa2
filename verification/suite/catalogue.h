// The verification catalogue: problems with an exact or published answer that suit a two-dimensional DDA engine, most
// fundamental first.
#pragma once

#include <string_view>
#include <vector>

namespace verify {

struct CatalogueProblem {
  int number;
  std::string_view title;
};

// Neighbouring problems about the same physics.
struct Area {
  std::string_view title;
  int first;  // number of its first problem
  int last;
};

// In the order of their numbers, from 1 without gaps.
[[nodiscard]] const std::vector<CatalogueProblem>& catalogue();

// Every problem is in one of them, in order.
[[nodiscard]] const std::vector<Area>& areas();

}  // namespace verify
