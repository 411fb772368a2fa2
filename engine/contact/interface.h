// Interfaces: where the outlines of two blocks touch. Found once from the reference geometry.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/core/types.h"
#include "engine/model/model.h"

namespace dda {

// A straight stretch along which two blocks touch; a single point (from == to) where a vertex of block b touches the
// inside of an edge of block a.
struct Interface {
  int block_a = 0;
  int block_b = 0;
  Vec2 from, to;      // reference coordinates; block a lies on the left of from -> to
  Vec2 normal;        // unit, from block a into block b
  double length = 0;  // m
  int joint = 0;      // index into Model::joints
  double share = 0;   // m, length of the joint for which each of its springs stands: half of a stretch
  double closed = 0;  // m, what of `share` lies on the other block, if it is one of a vertex: none of a corner's

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [block_a, block_b, from, to, normal, length, joint, share, closed] = self;
    archive.blocks(block_a, block_b);
    archive.joints(joint);
    archive(from, to, normal, length, share, closed);
  }
};

// The two blocks, the smaller index first.
inline std::pair<int, int> blocks_of(const Interface& interface) {
  return std::minmax(interface.block_a, interface.block_b);
}

// What a contact in a point stands for, of the smaller block's size (the side of the square with its area).
inline constexpr double point_share = 0.05;

// All interfaces of the model, sorted by (block_a, block_b), with block_a < block_b for stretches. A vertex that meets
// only another vertex makes none: bonded corners are held by the edges that meet there.
std::vector<Interface> find_interfaces(const Model& model);

}  // namespace dda
