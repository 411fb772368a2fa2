// Blocks that have no equilibrium at the end of a static stage, and the faces that hold them.
#pragma once

#include <string>
#include <vector>

#include "engine/core/types.h"
#include "engine/model/model.h"

namespace dda {

struct BlockSystem;

// Where a neighbour carries a block: all contacts of the two with one normal.
struct HoldingFace {
  int neighbour = 0;
  Vec2 place = Vec2::Zero();  // m, the middle of these contacts
  Vec2 force = Vec2::Zero();  // N per m of thickness, what the neighbour exerts on the block
  bool slides = false;        // at one of them at least

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [neighbour, place, force, slides] = self;
    archive.blocks(neighbour);
    archive(place, force, slides);
  }
};

// A block that has no equilibrium, and where its centroid was.
struct UnbalancedBlock {
  int stage = 0;
  int block = 0;
  Vec2 place = Vec2::Zero();            // m
  std::vector<HoldingFace> faces = {};  // that carry a force

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [stage, block, place, faces] = self;
    archive.stages(stage);
    archive.blocks(block);
    archive(place, faces);
  }
};

// With the stage under way, their places and the faces that hold them now.
std::vector<UnbalancedBlock> placed(const BlockSystem& system, const std::vector<int>& blocks);

// Those of one stage.
std::vector<UnbalancedBlock> of_stage(std::size_t stage, std::vector<UnbalancedBlock> blocks);

// For people: the first few by name and place, and how many more there are.
std::string named_with_places(const Model& model, const std::vector<UnbalancedBlock>& blocks);

// For people: one block with its number, place and mass, and the faces that hold it.
std::string described(const Model& model, const UnbalancedBlock& block);

}  // namespace dda
