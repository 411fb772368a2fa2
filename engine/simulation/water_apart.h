// Water in joints whose blocks have gone apart.
//
// A joint that opens keeps its pressure, as a crack that fills from a table does. What has left altogether is still
// pushed with the force of the closed joint, for as far as it goes, though no water would follow it: the work that this
// does is the scene's doing and has to be said.
#pragma once

#include <optional>

#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

struct WaterApart {
  int stage = 0;
  int block_a = 0, block_b = 0;
  int pairs = 0;     // of blocks in all, of which these are furthest apart
  double way = 0;    // m, from the middle of the face of one to that of the other
  double share = 0;  // the same by the size of the smaller block, the root of its area
  double time = 0;   // s

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [stage, block_a, block_b, pairs, way, share, time] = self;
    archive.stages(stage);
    archive.blocks(block_a, block_b);
    archive(pairs, way, share, time);
  }
};

// Joints open by thousandths of their blocks before these are what has left: by a hundredth the water between them is
// more than seeps in while blocks move.
inline constexpr double share_of_a_joint = 0.01;

// The pair that is furthest apart, by more than that share, of blocks that loads press on both faces of a joint of the
// drawing, now and in this stage; none where there is no such.
std::optional<WaterApart> water_apart(const Model& model, const State& state, std::size_t stage);

}  // namespace dda
