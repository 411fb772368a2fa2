#include "engine/cutting/corner_places.h"

#include <numeric>
#include <utility>

namespace dda {
namespace {

NodeRing without_repeats(const NodeRing& ring) {
  NodeRing kept;
  kept.reserve(ring.size());
  for (const int node : ring) {
    if (kept.empty() || kept.back() != node) kept.push_back(node);
  }
  while (kept.size() > 1 && kept.front() == kept.back()) kept.pop_back();
  return kept;
}

NodeRing in_place(const NodeRing& ring, const CornerPlaces& places) {
  NodeRing moved;
  moved.reserve(ring.size());
  for (const int node : ring) moved.push_back(places.node(node));
  return without_repeats(moved);
}

}  // namespace

CornerPlaces::CornerPlaces(std::vector<Vec2> positions)
    : same_as_(positions.size()),
      positions_(positions),
      drawn_positions_(std::move(positions)),
      ways_(same_as_.size(), 0.0) {
  std::iota(same_as_.begin(), same_as_.end(), 0);
}

double CornerPlaces::way_after(int node, int into, const Vec2& position) const {
  const auto way = [&](int each) { return ways_[at(each)] + (position - positions_[at(each)]).norm(); };
  return std::max(way(node), way(into));
}

Ring ring_of(const NodeRing& nodes, const CornerPlaces& places) {
  Ring ring;
  const NodeRing moved = in_place(nodes, places);
  ring.reserve(moved.size());
  for (const int node : moved) ring.push_back(places.position(node));
  return ring;
}

Polygon polygon_of(const NodeRings& rings, const CornerPlaces& places) {
  Polygon polygon;
  polygon.outer = ring_of(rings.front(), places);
  for (std::size_t i = 1; i < rings.size(); ++i) polygon.holes.push_back(ring_of(rings[i], places));
  return polygon;
}

}  // namespace dda
