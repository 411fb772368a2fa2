// Products of 6x6 blocks, two numbers at a time: a third quicker than general routines for matrices of fixed size.
#pragma once

#include <cstring>

#include "dda/core/types.h"

namespace dda {

namespace detail {

using Pair = double __attribute__((vector_size(16)));

inline Pair load_pair(const double* from) {
  Pair pair;
  std::memcpy(&pair, from, sizeof pair);
  return pair;
}
inline void store_pair(const Pair& pair, double* to) { std::memcpy(to, &pair, sizeof pair); }

// Two columns of c += sign a b, with b's entries of these columns at left[stride k] and right[stride k].
template <int sign, int stride>
void add_to_two_columns(const double* a, const double* left, const double* right, double* c) {
  Pair c0 = load_pair(c), c1 = load_pair(c + 2), c2 = load_pair(c + 4);
  Pair d0 = load_pair(c + 6), d1 = load_pair(c + 8), d2 = load_pair(c + 10);
#pragma GCC unroll 6
  for (int k = 0; k < 6; ++k) {
    const Pair a0 = load_pair(a + 6 * k), a1 = load_pair(a + 6 * k + 2), a2 = load_pair(a + 6 * k + 4);
    const double s = sign * left[stride * k];
    const double t = sign * right[stride * k];
    c0 += a0 * s, c1 += a1 * s, c2 += a2 * s;
    d0 += a0 * t, d1 += a1 * t, d2 += a2 * t;
  }
  store_pair(c0, c), store_pair(c1, c + 2), store_pair(c2, c + 4);
  store_pair(d0, c + 6), store_pair(d1, c + 8), store_pair(d2, c + 10);
}

}  // namespace detail

// c += a b
inline void add_product(const Mat6& a, const Mat6& b, Mat6& c) {
  for (int j = 0; j < 6; j += 2)
    detail::add_to_two_columns<1, 1>(a.data(), b.data() + 6 * j, b.data() + 6 * j + 6, c.data() + 6 * j);
}

// c -= a b^T
inline void subtract_product_transposed(const Mat6& a, const Mat6& b, Mat6& c) {
  for (int j = 0; j < 6; j += 2)
    detail::add_to_two_columns<-1, 6>(a.data(), b.data() + j, b.data() + j + 1, c.data() + 6 * j);
}

}  // namespace dda
