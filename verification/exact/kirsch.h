// Kirsch (1898): a circular opening in a plate under the far stresses sxx and syy; tension positive. Jaeger, Cook &
// Zimmerman, Fundamentals of rock mechanics, section 8.5.
#pragma once

#include <cmath>

namespace exact {

struct PolarStress {
  double radial = 0, hoop = 0, shear = 0;  // Pa
};

// `ratio`: radius of the opening over the distance from its centre, at most 1; `angle` from the x axis, rad.
[[nodiscard]] inline PolarStress kirsch(double far_xx, double far_yy, double ratio, double angle) {
  const double mean = (far_xx + far_yy) / 2;
  const double half = (far_xx - far_yy) / 2;
  const double r2 = ratio * ratio;
  const double r4 = r2 * r2;
  return {mean * (1 - r2) + half * (1 - 4 * r2 + 3 * r4) * std::cos(2 * angle),
          mean * (1 + r2) - half * (1 + 3 * r4) * std::cos(2 * angle),
          -half * (1 + 2 * r2 - 3 * r4) * std::sin(2 * angle)};
}

}  // namespace exact
