// The endless half of a block chain, shaken at its end: what a steady harmonic wave is at an interface.
#pragma once

#include "verification/exact/block_chain.h"
#include "verification/exact/time_scheme.h"

namespace exact {

// Compressive force at x = interface L, between the blocks `interface - 1` and `interface` counted from 0 at the end,
// over the force F0 exp(i omega t) on the end, by the time scheme of step dt (s); in the continuum exp(-i omega x/c).
// The waves of the chain that run or decay away from the end, with the amplitudes that the end block's equations give
// them; the chain's length and right end do not enter. Without damping it is the limit of little damping.
[[nodiscard]] Complex half_chain_force(const BlockChain& chain, const TimeScheme& scheme, double dt, double omega,
                                       int interface);

}  // namespace exact
