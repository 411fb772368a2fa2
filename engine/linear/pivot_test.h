// When a Cholesky factorization has met a singular matrix, in one place for all solvers.
#pragma once

namespace dda {

// `pivot` is what elimination left of the diagonal entry `diagonal`. Its round-off is a few ulp of that entry, so a
// pivot below 16 ulp of it carries no digit: the matrix is singular to working precision. The test does not depend on
// units (scaling an unknown scales both alike) and is false for NaN.
[[nodiscard]] constexpr bool is_sound_pivot(double pivot, double diagonal) {
  constexpr double smallest_ratio = 16 * 2.220446049250313e-16;
  return pivot > smallest_ratio * diagonal && pivot <= 1.7976931348623157e308;
}

}  // namespace dda
