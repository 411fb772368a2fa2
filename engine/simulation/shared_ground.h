// Blocks that occupy the same ground, by their outlines.
//
// How deep blocks are pressed into each other is otherwise told by contacts (penetration.h), and what no contact knows
// of is not among it: corners that a third block covers, depths that blocks were found with and that were forgiven,
// blocks that were held in the air while others moved through them. So outlines are compared as polygons, which no part
// of the search for contacts does.
#pragma once

#include <optional>
#include <vector>

#include "engine/core/types.h"

namespace dda {

struct BlockSystem;

struct SharedGround {
  int block_a = -1, block_b = -1;
  double depth = 0;           // m, of the deepest point that both have
  double share = 0;           // of the size of the smaller block
  Vec2 place = Vec2::Zero();  // m, of a corner that is deep in the other block, or between the two

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [block_a, block_b, depth, share, place] = self;
    archive.blocks(block_a);
    archive.blocks(block_b);
    archive(depth, share, place);
  }
};

// What a static stage left, which may be gone when the run ends.
struct SharedGroundOfStage {
  int stage = 0;
  SharedGround worst;
  int pairs = 0;  // with the worst

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [stage, worst, pairs] = self;
    archive.stages(stage);
    archive(worst, pairs);
  }
};

// A share of the smaller block's size: twice what sides in line may differ by (covered_corners.h), as covered corners
// of two blocks can both be in each other by as much.
inline constexpr double tolerated_share = 2e-3;

// What came in over another deeper than this share of the smaller one, as fill over a stone that lies in its place, is
// told of, though it stays so.
inline constexpr double told_share = 0.1;

// Pairs of blocks, not both held, that are deeper in each other by `least_share` of the smaller one than their contacts
// give way, than strains make of it (strain_jumps.h), and than they were when one of them came in, the worst first.
// Empty in small kinematics, where blocks stay where they were drawn.
std::vector<SharedGround> shared_ground(const BlockSystem& system, double least_share = tolerated_share);

// Notes how deep blocks that come in are in others, which have gone into their place meanwhile (excavated.h).
void note_came_in_over(const std::vector<int>& added, BlockSystem& system);

// What the stage under way has left of it; nothing where it left none.
std::optional<SharedGroundOfStage> shared_ground_of_stage(const BlockSystem& system);

}  // namespace dda
