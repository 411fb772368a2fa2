// Why an elastic block does not slide steadily under strong friction: friction, which follows the pressure on its two
// feet, couples the block's vibrations, and where two of them meet in frequency one grows (flutter by mode coupling,
// the squeal of brakes).
#pragma once

#include <complex>

namespace exact {

// A first-order block of plane stress, `width` by `height`, on a rigid plane under both its lower corners.
struct SlidingBlock {
  double width = 0, height = 0;  // m
  double density = 0;            // kg/m3
  double young = 0;              // Pa
  double poisson = 0;
  double normal_spring = 0;  // N/m, of each corner
};

// Growth rate (real part, 1/s) and circular frequency (imaginary part, rad/s) of the vibration that grows most while
// the block slides steadily with coefficient of friction mu; the real part is 0 where all are stable. From
//   M q'' + (K + k sum n n^T - mu k sum t n^T) q = 0
// over (u, v, r, ex, ey, gxy), n and t being the normal and tangential displacement of a corner by q.
[[nodiscard]] std::complex<double> fastest_growth(const SlidingBlock& block, double mu);

}  // namespace exact
