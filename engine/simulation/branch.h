// Branches: a scene that begins where a run of another scene of the same blocks was between two stages.
//
// What the blocks have been through goes on: places, velocities, stresses, contact forces, slip, what is broken,
// excavated or was let go, time, counters and the energy ledger. What acts from now on is the new scene's: its loads,
// strengths, supports, bolts, absorbing edges, and stages after those that are done. Supports and bolts that both
// scenes have keep their forces; new ones begin where the blocks are now, springs without force, bolts with their
// pretension; the others go with their forces, and what they had stored is external work.
#pragma once

#include "engine/simulation/simulation.h"

namespace dda {

// Brings `fresh`, which has not stepped, to where `settled` is, which is between two stages, and begins its next one.
// Where the two scenes are alike in all that has acted so far, it goes on to the last bit as a run of its whole scene
// would have. Throws InputError (without a file) naming what differs and must not, see branch_rule.h.
void begin_from(const Simulation& settled, Simulation& fresh);

// The same, unchecked.
void go_on_from(const Simulation& settled, Simulation& fresh);

}  // namespace dda
