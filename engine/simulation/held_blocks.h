// Blocks whose motion is prescribed exactly: what the model says of it, as increments of unknowns (HeldUnknowns).
//
// They have no inertia (make_block_terms), so that all that is left of them in the energies is the work of their
// motion.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/model/held_motion.h"
#include "engine/model/model.h"
#include "engine/model/state.h"
#include "engine/simulation/load_time.h"
#include "engine/solve/held_unknowns.h"

namespace dda {

// With the blocks that are `absent` (see BlockSystem), which stay where they are.
HeldUnknowns make_held_unknowns(const Model& model, const std::vector<bool>& absent = {});

// Adds a block that stays where it is, of `blocks` in all. Such blocks follow those of the model in the list.
void hold_still(int block, std::size_t blocks, HeldUnknowns& held);

// The increments that bring the model's held blocks from `state` to where they are to be at `time`.
void aim(const Model& model, const State& state, const LoadTime& time, HeldUnknowns& held);

// In how many steps the held blocks go straight from where they are at `start` to where they are at `end`, s, when they
// turn and move by no more than `most` of the smallest block's size in any of them, and turn by no more than
// `most_turn` (rad); never more than a static stage has steps for.
int steps_of_motion(const Model& model, double start, double end, double most, double most_turn);

// Displacement of the unknowns of a held block at `time`.
Vec6 prescribed_displacement(const Model& model, const HeldMotions& motions, double time);

// True when the blocks are at `time` where they are now.
bool held_blocks_stand_still_until(const Model& model, const State& state, double time);

// Prescribed velocities and accelerations at the state's time.
void set_held_rates(const Model& model, State& state);

}  // namespace dda
