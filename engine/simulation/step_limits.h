// What a step may do and still be believed, and what is said when it does more.
#pragma once

#include <string>

#include "engine/simulation/block_system.h"
#include "engine/solve/contact_solver.h"

namespace dda {

// A block may turn, or be strained, by this much in a step (rad) where contacts are followed: first-order gaps are then
// off by its size times half the square.
inline constexpr double most_turn = 0.01;

// Geometry is followed, and the matrix built anew, when some block has moved by this share of its size: directions are
// then off by as much, and gaps by half its square. A static stage that is not in balance after some steps bears with
// less than what it asks of the balance: what weight alone holds, as a block that hangs on bolts or on the tip of
// another, would else go to and fro by as much for ever. (Walls and rock that settle come to rest before that.)
double geometry_tolerance(const BlockSystem& system);

// Whether the step that was accepted has moved blocks so far that what it left in balance where they lay is not where
// they lie, by more than a hundred-thousandth of what they moved.
bool goes_far_for_its_geometry(const BlockSystem& system);

// Whether the step under way is a part that is not cut further.
bool is_shortest_part(const BlockSystem& system);

// The motion of the block that moves most by system.increment, in its own size (see motion_share).
double largest_motion(const BlockSystem& system);

// In a static step: drag for what goes too far by system.increment, but for what it is carried along. True when there
// was any: the step is to be solved anew.
bool hold_back_what_goes_far(BlockSystem& system);

// In such a step that is accepted: true when more blocks are loose from now on (SettlingDrag::follow).
bool finds_loose_blocks(BlockSystem& system);

// The same as largest_motion for what each block would do within `time` (s) if it went on as it moves now.
double largest_motion_within(const BlockSystem& system, double time);

// Which block would turn or be strained too far for first-order gaps by system.increment; empty when none.
std::string turn_problem(const BlockSystem& system);

// The same by what it would do in the step under way if it went on as it moves now. Hardly any block that spins so fast
// is braked within the step, which need not be solved to be cut then.
std::string foreseen_turn_problem(const BlockSystem& system);

// How many passes an open-close iteration may take. A stage that paces itself tries a shorter step rather than go on:
// what settles at all mostly does in fewer passes.
int most_passes(const Stage& stage);

// Whether steps that do not settle quickly take interior passes.
bool goes_from_inside(const BlockSystem& system);

// Takes note of a step that was not settled as a whole, and where it was not.
void note_unsettled(const StepSolution& solution, BlockSystem& system);

// Says where an open-close iteration that did not settle still changes most.
std::string unsettled_message(const StepSolution& solution, const BlockSystem& system);

}  // namespace dda
