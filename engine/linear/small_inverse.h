// The inverse of one symmetric positive definite 6x6 block by sweeping one pivot after another (Beaton 1964): six
// divisions and no square root.
#pragma once

#include "engine/core/types.h"
#include "engine/linear/pivot_test.h"

namespace dda {

// False where the block is not positive definite; the pivots are those of Cholesky's factorization. The inverse is
// symmetric to the last bit.
inline bool invert_block(const Mat6& block, Mat6& inverse) {
  Mat6 swept = block;
  for (int k = 0; k < 6; ++k) {
    const double pivot = swept(k, k);
    if (!is_sound_pivot(pivot, block(k, k))) return false;
    const double reciprocal = 1 / pivot;
    const Vec6 column = swept.col(k);
    for (int c = 0; c < 6; ++c) swept.col(c) -= (column * column(c)) * reciprocal;
    swept.col(k) = column * reciprocal;
    swept.row(k) = swept.col(k).transpose();
    swept(k, k) = -reciprocal;
  }
  inverse = -swept;
  return true;
}

}  // namespace dda
