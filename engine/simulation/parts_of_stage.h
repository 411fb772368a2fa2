// In how many parts loads and motions get to the end of a static stage that finds its own steps, and when the next
// begins.
#pragma once

#include "engine/simulation/load_parts.h"

namespace dda {

struct BlockSystem;

// The parts of the stage that begins: one where nothing changes, or where everything is linear and one does as well.
// Blocks that are moved far go in as many as it takes to miss no contact. Writes the loads at the end to
// forces.load_new.
LoadParts parts_of_stage(bool contacts_are_followed, BlockSystem& system);

// A step of the stage has settled. `in_situ_force` (N): as for out_of_balance(). `steps_are_long`: so that inertia is
// next to nothing in the next one.
void go_on_with_loads(double in_situ_force, bool steps_are_long, BlockSystem& system);

// Whether the step under way only waits, and would move some block further than the last part moved any. Turns of that
// part have left stiff contacts open or closed by more than they give way; long steps have other answers then than the
// one nearby, in which blocks fall freely.
bool goes_further_than_the_last_part(const BlockSystem& system);

}  // namespace dda
