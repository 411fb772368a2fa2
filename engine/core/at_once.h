// Two different things at once.
#pragma once

#include <cstddef>

#include "engine/core/parallel.h"

namespace dda {

// Calls both, on two threads if as many are in use; returns when both are done. Neither may throw, and what they share
// among threads themselves each does alone.
template <typename One, typename Other>
void at_once(const One& one, const Other& other) {
  for_each_piece({2, 2}, [&](std::size_t piece, std::size_t, std::size_t) {
    if (piece == 0)
      one();
    else
      other();
  });
}

}  // namespace dda
