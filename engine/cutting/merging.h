// Blocks that are too narrow, too small or too sharp go to a neighbour.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/cutting/trace.h"

namespace dda {

struct MergeLimits {
  double width = 0;  // m, of 2 area / perimeter: narrower blocks are slivers
  double area = 0;   // m2
  double angle = 0;  // rad, of the sharpest corner
};

struct Merging {
  std::vector<Outline> outlines;  // of the blocks that are left
  std::vector<Cleaned> cleaned;
  int merged = 0;
  double dropped_area = 0;
  std::size_t traced = 0;  // outlines, over all rounds
};

// Merges until no block is below the limits, each time the smallest first, with the neighbour that has most of its
// outline; a neighbour in the same opening, or like it in none, goes before others.
Merging merge_blocks(const Arrangement& arrangement, const std::vector<FacePlace>& places, const MergeLimits& limits,
                     FaceGroups& groups);

}  // namespace dda
