// The contacts that can change at the end of a step: their states become those of its trials, and the ledger learns
// what they took.
#pragma once

#include "engine/simulation/block_system.h"
#include "engine/solve/interface_trials.h"

namespace dda {

// `moves`: contacts are those that are followed, and open stretches slip as their blocks go.
void accept_contacts(const InterfaceTrials& trials, bool moves, BlockSystem& system);

}  // namespace dda
