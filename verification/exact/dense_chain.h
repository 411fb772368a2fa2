// The block chain assembled densely from its potentials and stepped in time: shares nothing but its data with
// finite_chain.
#pragma once

#include "verification/exact/block_chain.h"
#include "verification/exact/dense_newmark.h"

namespace exact {

// Matrices of the 3 blocks unknowns (u0, ex, ey of each block in turn).
[[nodiscard]] DenseSystem dense_chain_system(const BlockChain& chain);

// Histories under a force load[i] (N, at t = i dt) spread over the left face, positive in +x (compression).
// Throws std::invalid_argument on bad data.
[[nodiscard]] ChainHistories dense_chain_response(const BlockChain& chain, const TimeScheme& scheme, double dt,
                                                  const std::vector<double>& load,
                                                  const std::vector<ChainProbe>& probes);

}  // namespace exact
