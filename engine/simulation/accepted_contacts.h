// The contacts that can change at the end of a step: their states become those of its trials, and the ledger learns
// what they took.
#pragma once

#include "engine/simulation/block_system.h"
#include "engine/solve/interface_trials.h"

namespace dda {

// `moves`: contacts are those that are followed, and open stretches slip as their blocks go. In static steps returns
// how much of their friction is beyond what the shear at the end of the step takes, J per m of thickness.
double accept_contacts(const InterfaceTrials& trials, bool moves, BlockSystem& system);

// J per m of thickness: what settling has taken so far.
double taken_by_settling(const EnergyLedger& ledger);

// Friction is booked by the mean shear of a slip, which is right where forces change evenly. A static step has the
// forces of its end from its start on, and contacts may let go early in it: where a corner slides off another block,
// joints beside it slide most of the way with little pressure. The mean then takes more than was set free, which
// settling, of which there was so much before the step, would have to give. So friction is less by that, and at least
// what the shear at the end takes: `beyond_end` is what accept_contacts() returned.
void keep_friction_to_balance(double settling_before, double beyond_end, BlockSystem& system);

}  // namespace dda
