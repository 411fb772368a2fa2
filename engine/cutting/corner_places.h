// Where corners of blocks are in the end: two that are nearer than the tolerance become one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "engine/geometry/polygon.h"

namespace dda {

using NodeRing = std::vector<int>;
using NodeRings = std::vector<NodeRing>;  // of a block, the outer one first

class CornerPlaces {
 public:
  // By node, as drawn.
  explicit CornerPlaces(std::vector<Vec2> positions);

  // The node that `drawn` has become.
  [[nodiscard]] int node(int drawn) const {
    while (same_as_[at(drawn)] != drawn) drawn = same_as_[at(drawn)];
    return drawn;
  }
  [[nodiscard]] const Vec2& position(int drawn) const { return positions_[at(node(drawn))]; }
  [[nodiscard]] const Vec2& drawn_position(int drawn) const { return drawn_positions_[at(drawn)]; }

  // m: no node has gone farther from where it was drawn. Does not shrink when something is undone.
  [[nodiscard]] double farthest() const { return farthest_; }

  // Puts `node` where `into` is, and that at `position`. The answer undoes it.
  auto close(int node, int into, const Vec2& position) {
    auto undo = [this, node, into, old = positions_[at(into)], old_ways = ways_[at(into)]] {
      same_as_[at(node)] = node;
      positions_[at(into)] = old;
      ways_[at(into)] = old_ways;
    };
    ways_[at(into)] = way_after(node, into, position);
    farthest_ = std::max(farthest_, ways_[at(into)]);
    same_as_[at(node)] = into;
    positions_[at(into)] = position;
    return undo;
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] double way_after(int node, int into, const Vec2& position) const;

  std::vector<int> same_as_;
  std::vector<Vec2> positions_;
  std::vector<Vec2> drawn_positions_;
  std::vector<double> ways_;  // m, by node: those that became it have not gone farther
  double farthest_ = 0;
};

// The ring as it is now: nodes that became one follow each other once.
Ring ring_of(const NodeRing& nodes, const CornerPlaces& places);
Polygon polygon_of(const NodeRings& rings, const CornerPlaces& places);

}  // namespace dda
