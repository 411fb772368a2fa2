// Loads of chains whose inertia is lowered to make up for the period error of time steps.
//
// Time steps take S = omega^2 (1 + e omega^2 dt^2) for omega^2. With M - e dt^2 K in place of M the equation
// (K - S M) u = F becomes (1 + e omega^2 dt^2) (K - omega^2 M) u = F to that order: the right motion under F over
// (1 + e omega^2 dt^2). F less e times its second difference over dt undoes that. (With beta = 1/4 and e = 1/6 it is
// the fourth-order rule of Fox & Goodwin 1949, whose loads are weighed 1/12, 10/12, 1/12.)
#pragma once

#include <vector>

#include "verification/exact/block_chain.h"

namespace exact {

// e of a chain: interface.inertia_reduction over (c dt/L)^2; 0 where inertia is not lowered.
[[nodiscard]] double load_sharpening(const BlockChain& chain, double dt);

// load[i] at t = i dt; after the last sample it is as that. The first is left as it is: a run starts from rest under
// it.
[[nodiscard]] std::vector<double> sharpened(const std::vector<double>& load, double share);

}  // namespace exact
