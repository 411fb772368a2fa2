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
    archive(stage, block, place);
  }
};

// Largest unbalanced force of any unknown over the largest load, weight or `in_situ_force` (N per m of thickness);
// moments over the root of the block's area.
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
