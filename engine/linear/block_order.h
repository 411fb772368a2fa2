// The order in which an incomplete factorization eliminates blocks.
#pragma once

#include <vector>

#include "engine/linear/block_matrix.h"

namespace dda {

// Reverse Cuthill-McKee: neighbours get near places, so little of a factor is dropped and its parts are near in memory.
// Blocks with over `hub_degree` neighbours (a floor under many) come last: eliminated early, they would couple all
// their neighbours with each other. order[k] is the block eliminated as the k-th.
inline constexpr int hub_degree = 24;
std::vector<int> cuthill_mckee_order(const BlockMatrix& matrix);

}  // namespace dda
