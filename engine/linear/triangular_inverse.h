// The inverse of one triangular 6x6 block, with the loops written out: general routines take longer to start than this
// takes to finish.
#pragma once

#include "engine/core/types.h"

namespace dda {

// L^-1 of a lower triangular L, lower triangular too.
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
