// Cholesky factorization of one 6x6 block, with the loops written out: general routines take longer to start than this
// takes to finish.
#pragma once

#include <cmath>

#include "dda/core/types.h"
#include "dda/linear/pivot_test.h"

namespace dda {

// The lower factor L of block = L L^T; reads the lower triangle only. False where the block is not positive definite.
inline bool factor_block(const Mat6& block, Mat6& lower) {
  lower.setZero();
  for (int c = 0; c < 6; ++c) {
    double pivot = block(c, c);
    for (int k = 0; k < c; ++k) pivot -= lower(c, k) * lower(c, k);
    if (!is_sound_pivot(pivot, block(c, c))) return false;
    lower(c, c) = std::sqrt(pivot);
    const double reciprocal = 1 / lower(c, c);  // six divisions instead of twenty-one
    for (int r = c + 1; r < 6; ++r) {
      double sum = block(r, c);
      for (int k = 0; k < c; ++k) sum -= lower(r, k) * lower(c, k);
      lower(r, c) = sum * reciprocal;
    }
  }
  return true;
}

// L^-1, lower triangular too.
inline Mat6 inverse_of_lower(const Mat6& lower) {
  Mat6 inverse = Mat6::Zero();
  for (int c = 0; c < 6; ++c) inverse(c, c) = 1 / lower(c, c);
  for (int c = 0; c < 6; ++c) {
    for (int r = c + 1; r < 6; ++r) {
      double sum = 0;
      for (int k = c; k < r; ++k) sum += lower(r, k) * inverse(k, c);
      inverse(r, c) = -sum * inverse(r, r);
    }
  }
  return inverse;
}

}  // namespace dda
