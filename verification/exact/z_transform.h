// Discrete histories and their z-transforms X(z) = sum x_n z^-n on a circle |z| = radius > 1.
#pragma once

#include <cstddef>
#include <vector>

#include "verification/exact/time_scheme.h"

namespace exact {

// Sampling a transform at N points of the circle returns x_n + radius^-N x_(n+N) + ...; round-off grows by radius^n.
// With N >= 4 histories and radius^N = 1e14 the first is 1e-14 of the motion's scale and the second below 1e4 epsilon
// of the extended precision.
class ZCircle {
 public:
  // For histories of `length` samples.
  explicit ZCircle(std::size_t length);

  // Points in the upper half plane, z_0 = radius to z_(N/2) = -radius; real histories need no others.
  [[nodiscard]] std::size_t points() const { return size_ / 2 + 1; }
  [[nodiscard]] Complex point(std::size_t i) const;

  // Transform of a history (at most `length` samples) at every point.
  [[nodiscard]] std::vector<Complex> forward(const std::vector<double>& history) const;

  // History of `length` samples with the given values of its transform at the points.
  [[nodiscard]] std::vector<double> inverse(const std::vector<Complex>& transform) const;

 private:
  std::size_t length_;
  std::size_t size_;
  Real log_radius_;
};

}  // namespace exact
