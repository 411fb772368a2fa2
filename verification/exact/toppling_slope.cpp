#include "verification/exact/toppling_slope.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace exact {

double TopplingSlope::height(int column) const {
  const double rise = lower_step - base_step;
  const double fall = upper_step + base_step;
  return column <= crest ? column * rise : crest * rise - (column - crest) * fall;
}

TopplingSlope goodman_bray_slope() {
  TopplingSlope slope;
  slope.dip = std::numbers::pi / 6;
  return slope;
}

std::vector<double> column_forces(const TopplingSlope& slope, double friction) {
  std::vector<double> forces(static_cast<std::size_t>(slope.columns) + 1, 0);
  const double sine = std::sin(slope.dip);
  const double cosine = std::cos(slope.dip);
  for (int n = slope.columns; n >= 1; --n) {
    const double y = slope.height(n);
    const double upper_arm = n < slope.crest ? y : y - slope.upper_step;   // M_n
    const double lower_arm = n <= slope.crest ? y - slope.lower_step : y;  // L_n
    const double weight = slope.unit_weight * y * slope.width;
    const double from_above = forces[static_cast<std::size_t>(n)];
    const double sliding = from_above - weight * (cosine * friction - sine) / (1 - friction * friction);
    // A column no higher than the step in front of it has nothing to topple over.
    const double toppling =
        lower_arm > 0
            ? (from_above * (upper_arm - slope.width * friction) + weight / 2 * (y * sine - slope.width * cosine)) /
                  lower_arm
            : -std::numeric_limits<double>::infinity();
    const double needed = std::max(sliding, toppling);
    forces[static_cast<std::size_t>(n - 1)] = n > 1 ? std::max(needed, 0.0) : needed;
  }
  return forces;
}

double limiting_friction(const TopplingSlope& slope, double low, double high) {
  while (high - low > 1e-14) {
    const double middle = (low + high) / 2;
    if (middle <= low || middle >= high) break;
    (column_forces(slope, middle).front() > 0 ? low : high) = middle;
  }
  return high;
}

}  // namespace exact
