// Straight line through points by least squares.
#pragma once

#include <vector>

namespace verify {

struct LinearFit {
  double slope = 0;
  double explained = 0;  // share of the variance that the line explains, R2; 1 where nothing varies
};

// Of equally many, at least two.
[[nodiscard]] LinearFit fit_line(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace verify
