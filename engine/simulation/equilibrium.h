// What is left of static equilibrium, and which blocks have none.
#pragma once

#include <string>
#include <vector>

#include "engine/core/types.h"
#include "engine/model/model.h"

namespace dda {

struct BlockSystem;

// A block that has no equilibrium, and where its centroid was.
struct UnbalancedBlock {
  int stage = 0;
  int block = 0;
  Vec2 place = Vec2::Zero();  // m

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [stage, block, place] = self;
    archive.stages(stage);
    archive.blocks(block);
    archive(place);
  }
};

// In static stages, when one begins and after each of its steps: notes what blocks, supports and bolts exchange now,
// for out_of_balance() to know when it has become next to nothing.
void note_exchanged_forces(BlockSystem& system);

// Largest unbalanced force of any unknown over the largest force that acts: load, weight or `in_situ_force` (N per m of
// thickness), and where a motion is prescribed, bolts have a pretension, or nothing acts, the largest force exchanged.
// Moments over the root of the block's area. No size of its own comes in: a scene of millimetres and one of kilometres
// have the same share. Without loads, what is no more than round-off of the motion so far is no force.
double out_of_balance(const BlockSystem& system, double in_situ_force);

// Blocks that are out of balance by more than `share` of that, the worst first.
std::vector<int> blocks_out_of_balance(const BlockSystem& system, double in_situ_force, double share);

// Why the static stage under way, which is at its end, is no equilibrium; empty where it is. Loose blocks, which are
// held, are a reason where no stage follows.
std::string equilibrium_problem(const BlockSystem& system, double in_situ_force);

// With the stage under way and their places now.
std::vector<UnbalancedBlock> placed(const BlockSystem& system, const std::vector<int>& blocks);

// For people: the first few by name and place, and how many more there are.
std::string named_with_places(const Model& model, const std::vector<UnbalancedBlock>& blocks);

}  // namespace dda
