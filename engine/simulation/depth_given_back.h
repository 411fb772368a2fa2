// Blocks that static steps have left in each other are pushed apart before the stage ends.
//
// What the first-order gaps of a step miss where blocks turn, and what a stretch that has parted leaves to stiffer
// springs, contacts forgive: their springs close deeper by as much (inherited_state.h). In motion that is what keeps
// energy from coming out of nowhere. In a static stage the way is of no interest, and blocks left in each other are
// wrong.
#pragma once

namespace dda {

struct BlockSystem;

// Takes back a part of what contacts were forgiven between blocks that share ground, as shared_ground.h finds them.
// True where there was any: the blocks then are out of balance, and the stage has to go on.
bool give_back_depths(BlockSystem& system);

}  // namespace dda
