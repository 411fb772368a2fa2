// Bolts and linings that a later stage puts in where blocks have parted. Nothing bonds a grouted bolt, and nothing
// backs sprayed concrete, on a way through air. Where it is drawn that is refused; what has moved by then a run can
// only tell.
#pragma once

#include <vector>

namespace dda {

struct BlockSystem;

struct ReinforcementInAir {
  bool is_lining = false;
  int number = 0;  // of the bolt or lining
  int block_a = -1, block_b = -1;
  double way = 0;  // m, by which its two points on these blocks are farther from each other than drawn

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [is_lining, number, block_a, block_b, way] = self;
    archive(is_lining, number);
    archive.blocks(block_a);
    archive.blocks(block_b);
    archive(way);
  }
};

// Appends the widest place of each bolt and lining that the stage which begins puts in through air.
void note_reinforcement_in_air(const BlockSystem& system, std::vector<ReinforcementInAir>& all);

}  // namespace dda
