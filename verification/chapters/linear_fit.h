// Straight line through points by least squares.
#pragma once

#include <vector>

namespace verify {

struct LinearFit {
  double slope = 0;
  double explained = 0;  // share of the variance that the line explains, R2; 1 where nothing varies
};

// The line of least squares through points, of which there are at least two; `x` and `y` are equally many.
[[nodiscard]] LinearFit fit_line(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace verify
