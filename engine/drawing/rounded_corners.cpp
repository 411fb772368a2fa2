#include "engine/drawing/rounded_corners.h"

#include <algorithm>
#include <map>
#include <utility>

#include "engine/geometry/box.h"

namespace dda {
namespace {

constexpr int most_rounds = 8;  // corners on edges whose ends are on edges: each round leaves a part of the last

using Place = std::pair<double, double>;

// Whether anything moved.
bool move_corners(double reach, std::vector<Ring>& blocks) {
  std::map<Place, Vec2> moved;
  {
    const BlockEdges edges(blocks, reach);
    for (const Ring& block : blocks) {
      for (const Vec2& corner : block) moved.try_emplace({corner.x(), corner.y()}, edges.on_edge(corner));
    }
  }
  bool any = false;
  for (Ring& block : blocks) {
    for (Vec2& corner : block) {
      const Vec2& place = moved.at({corner.x(), corner.y()});
      any = any || place != corner;
      corner = place;
    }
  }
  return any;
}

}  // namespace

BlockEdges::BlockEdges(const std::vector<Ring>& blocks, double reach)
    : blocks_(blocks), reach_(reach), index_(boxes()) {}

std::vector<Box> BlockEdges::boxes() {
  std::vector<Box> boxes;
  for (std::size_t block = 0; block < blocks_.size(); ++block) {
    for (std::size_t first = 0; first < blocks_[block].size(); ++first) {
      edges_.push_back({block, first});
      const Segment segment = edge(block, first);
      boxes.push_back(expanded(expanded(Box{segment.start, segment.start}, segment.end), reach_));
    }
  }
  return boxes;
}

Segment BlockEdges::edge(std::size_t block, std::size_t first) const {
  const Ring& ring = blocks_[block];
  return {ring[first], ring[(first + 1) % ring.size()]};
}

bool BlockEdges::touches_another(std::size_t block, const Segment& own) const {
  return std::ranges::any_of(index_.overlapping(expanded(Box{own.start, own.start}, own.end)), [&](int i) {
    const Edge& other = edges_[static_cast<std::size_t>(i)];
    return other.block != block && collinear_overlap(own, edge(other.block, other.first), reach_).has_value();
  });
}

Vec2 BlockEdges::on_edge(const Vec2& corner) const {
  for (const int i : index_.overlapping(Box{corner, corner})) {
    const Edge& other = edges_[static_cast<std::size_t>(i)];
    const Segment segment = edge(other.block, other.first);
    if ((segment.start - corner).norm() < reach_ || (segment.end - corner).norm() < reach_) continue;
    if (Vec2 place = closest_point(segment, corner); (place - corner).norm() < reach_) return place;
  }
  return corner;
}

void put_corners_on_edges(double reach, std::vector<Ring>& blocks) {
  for (int round = 0; round < most_rounds && move_corners(reach, blocks); ++round) continue;
}

}  // namespace dda
