// Rock of blocks that are given as they are.
#pragma once

#include "engine/cutting/rock_in_blocks.h"
#include "engine/cutting/rock_plan.h"

namespace dda {

// The blocks of the plan, to the bit, in the order that cutting gives them, with joints along its lines. A line along
// which no two blocks touch is left out, and listed. `tolerance` (m) as in CutOptions. Throws InputError for a block
// that is none, and for a line through the inside of one, as nothing is cut here.
CutRock given_rock(const RockPlan& plan, double tolerance);

}  // namespace dda
