// The deepest that blocks were pressed into each other in a run.
#pragma once

#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/model/state.h"
#include "engine/simulation/block_terms.h"
#include "engine/simulation/depth_in_thickness.h"

namespace dda {

struct Penetration {
  double depth = 0;  // m
  double share = 0;  // of the size of the smaller block
  int block_a = -1, block_b = -1;
  double time = 0;                // s
  DepthInThickness in_thickness;  // the largest share of a thickness, which may be that of another contact

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [depth, share, block_a, block_b, time, in_thickness] = self;
    archive.blocks_or_none(block_a, block_b);
    archive(depth, share, time, in_thickness);
  }
};

// Beyond this share a run is doubtful: joints are too soft for what presses them, or a step too long for an impact.
inline constexpr double tolerated_penetration = 0.01;

// Takes note of contacts whose blocks are deeper in each other than any before.
void note_penetrations(const Model& model, const ContactSet& contacts, const BlockTerms& terms, const State& state,
                       Penetration& deepest);

}  // namespace dda
