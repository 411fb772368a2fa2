// The order in which an incomplete factorization eliminates blocks.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/linear/block_matrix.h"

namespace dda {

// Reverse Cuthill-McKee: neighbours get near places, so little of a factor is dropped and its parts are near in memory.
// Blocks with over `hub_degree` neighbours (a floor under many) come last: eliminated early, they would couple all
// their neighbours with each other. order[k] is the block eliminated as the k-th.
inline constexpr int hub_degree = 24;
std::vector<int> cuthill_mckee_order(const BlockMatrix& matrix);

// Places in an order: [0, first) and [first, second) are halves that know nothing of each other, and what couples them
// comes after both.
struct Halves {
  std::size_t first = 0, second = 0;
};

// Cuts an order into halves that can be eliminated side by side, the second from its far end on, as the first is: what
// is dropped lies where it did. None where more than an eighth of all would have to come after them.
Halves cut_in_halves(const BlockMatrix& matrix, std::vector<int>& order);

}  // namespace dda
