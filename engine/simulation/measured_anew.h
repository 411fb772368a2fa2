// Forces that jump where gaps are measured anew, and what acted in their place.
//
// The rows of a step belong to one moment of it. What they miss where blocks turn, a way of second order in the turn,
// is put right at the start of the next step, and with it forces jump by the stiffness times that way, which nothing
// has balanced. A balance with a share alpha_f of the forces at the start has to have them as the last step ended with
// them: with the jump in, those at its end would be off by -alpha_f of it, and who reads them, or judges friction and
// strength by them, would see much of the jump where joints and supports are stiff, and nothing of it in the motion.
// Contacts of vertices foresee what their rows miss (engine/contact/foreseen_gap.h).
#pragma once

#include "engine/simulation/block_system.h"

namespace dda {

// To be called before gaps are measured anew: remembers what acts, if it is the first time in this step.
void note_forces(BlockSystem& system);

// To be called when they have been: by how much that has changed the forces on the blocks.
void compare_forces(BlockSystem& system);

}  // namespace dda
