// What is left of static equilibrium, which blocks have none, and whether a run goes on without it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/model/model.h"
#include "engine/simulation/unbalanced_block.h"

namespace dda {

struct BlockSystem;

// In static stages, when one begins and after each of its steps: notes what blocks, supports and bolts exchange now,
// for out_of_balance() to know when it has become next to nothing.
void note_exchanged_forces(BlockSystem& system);

// Largest unbalanced force of any unknown over the largest force that acts: load, weight or `in_situ_force` (N per m of
// thickness), and where a motion is prescribed, bolts have a pretension, or nothing acts, the largest force exchanged.
// Moments over the root of the block's area. No size of its own comes in: a scene of millimetres and one of kilometres
// have the same share. Without loads, and in linear stages, what is no more than round-off of the motion so far is no
// force. A block whose own weight and load are less than a millionth of that largest force is measured by a million
// times these: a pebble beside a mountain that hangs in the air is out of balance. (Not in linear stages, where blocks
// stay where they are, nor where round-off of gaps makes more force than the block weighs.)
double out_of_balance(const BlockSystem& system, double in_situ_force);

// In static stages that ask for equilibrium, before each step: notes how much may be left out of balance on each block,
// for steps that begin with more, though with little beside the forces of their contacts, to take a pass all the same.
void note_asked_balance(BlockSystem& system, double in_situ_force);

// At the end of the stage under way: the blocks that are out of balance by more than the stage asks for, the worst
// first. None where it does not ask.
std::vector<UnbalancedBlock> find_blocks_out_of_balance(const BlockSystem& system, double in_situ_force);

// How a stage ended.
struct StageEnd {
  std::size_t stage = 0;
  double out_of_balance = 0;                // as out_of_balance()
  std::vector<UnbalancedBlock> loose;       // blocks that nothing held
  std::vector<UnbalancedBlock> unbalanced;  // as find_blocks_out_of_balance()
};

// Why a run is to end with a stage, which is no equilibrium; empty where it may go on. What counts as a reason is the
// stage's `on_unbalanced`.
std::string equilibrium_problem(const Model& model, const StageEnd& end);

}  // namespace dda
