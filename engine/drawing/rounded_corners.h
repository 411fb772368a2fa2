// Blocks whose coordinates were rounded when they were written.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/geometry/box_pairs.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/segment.h"

namespace dda {

// Where a joint ends at another, the corner lies on an edge of the block beyond. Rounded, it lies beside it, and the
// blocks overlap or part by that. Corners nearer than `reach` (m) to an edge that does not end there are put onto it;
// copies of a corner go together.
void put_corners_on_edges(double reach, std::vector<Ring>& blocks);

// The edges of blocks, found by where they are. Keeps a reference to the blocks.
class BlockEdges {
 public:
  BlockEdges(const std::vector<Ring>& blocks, double reach);

  // From vertex `first` of the block.
  [[nodiscard]] Segment edge(std::size_t block, std::size_t first) const;

  // Whether a block other than that one has an edge that runs along within the reach.
  [[nodiscard]] bool touches_another(std::size_t block, const Segment& edge) const;

  // The place nearest to the corner on an edge nearer than the reach, where that does not end there; else the corner.
  [[nodiscard]] Vec2 on_edge(const Vec2& corner) const;

 private:
  struct Edge {
    std::size_t block = 0;
    std::size_t first = 0;
  };

  std::vector<Box> boxes();

  const std::vector<Ring>& blocks_;
  double reach_;
  std::vector<Edge> edges_;
  BoxIndex index_;
};

}  // namespace dda
