// Closed form of the discrete problem "block chain + time scheme": per z, waves of the homogeneous chain from both
// ends, their amplitudes from the end conditions, and an inverse z-transform. An engine that solves what it claims
// matches it to round-off; cost grows with the number of steps, not with the number of blocks.
#pragma once

#include <vector>

#include "verification/exact/block_chain.h"
#include "verification/exact/time_scheme.h"

namespace exact {

// Histories under a force load[i] (N, at t = i dt) spread over the left face, positive in +x (compression). Starts from
// rest with M a_0 = F_0; if load[0] is not 0 and there is an end dashpot, the chain needs two blocks or more.
// Accuracy: 1e-11 of each probe's largest value. Throws std::invalid_argument on bad data.
[[nodiscard]] ChainHistories finite_chain_response(const BlockChain& chain, const TimeScheme& scheme, double dt,
                                                   const std::vector<double>& load,
                                                   const std::vector<ChainProbe>& probes);

}  // namespace exact
