// Blocks that are carried along by a held block that moves, in static stages.
//
// Rows of the start of a step know nothing of a turn: blocks that turn together with what they stand on seem to grow by
// half its square, press each other by as much of their modulus, and slip. And the inertia of a static step, without
// which it would not settle, holds blocks back against what moves under them. So the step begins with the velocity that
// takes each block along as a rigid body: its geometry is that of half-way, where rows miss nothing but the third order
// (foreseen_gap.h), and its inertia acts against what differs from that motion alone. Velocities of static stages are
// zero before a step and after it.
#pragma once

#include "engine/simulation/block_system.h"

namespace dda {

// Sets the velocities of the step under way, for which held blocks have been aimed at. Carried are all blocks that hang
// together by contacts that are closed, or by bolts, if the held blocks that they touch move as one rigid body, and no
// support holds them.
void carry_along(BlockSystem& system);

// The increments of the step under way less those of being carried along.
Eigen::VectorXd own_increments(const BlockSystem& system);

// The velocities are zero again, after a step that did not come about.
void put_down(BlockSystem& system);

// True in a step of a static stage that moves held blocks, and follows how blocks turn.
bool takes_blocks_along(const BlockSystem& system);

}  // namespace dda
