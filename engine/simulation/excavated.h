// What excavation and building leave in a system: which blocks are absent, what they exerted on the others, and which
// came in over others.
#pragma once

#include <vector>

#include "engine/simulation/released_forces.h"

namespace dda {

// A block came in over another, smaller index first, which had gone into its place meanwhile.
struct CameInOver {
  int block_a = -1, block_b = -1;
  double depth = 0;  // m, of the deepest point that both had then
  double share = 0;  // of the size of the smaller block

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [block_a, block_b, depth, share] = self;
    archive.blocks(block_a, block_b);
    archive(depth, share);
  }
};

struct Excavated {
  std::vector<bool> absent;  // of every block whether it is not there now; empty while all are
  ReleasedForces released;
  std::vector<CameInOver> came_in_over;  // they are seated so (join_blocks.h), and share ground from then on

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [absent, released, came_in_over] = self;
    archive(released, came_in_over);  // what is absent follows from the stage
  }
};

}  // namespace dda
