// How deep blocks were pressed into each other, by the thickness of what they were pressed into.
//
// A contact pushes back through the face by which its corner came in for as long as that is the nearest way out. Beyond
// the middle of a plate the way out is through the far side, and a corner that is there goes on: the block has passed
// through, and nothing at the end of the run shows it, as blocks that have passed do not overlap. So the deepest of the
// whole run is kept. The thickness is that of the face's block at the corner, straight through from the face: neither
// the side of the square of a block's area (3.7 % of which are all of a plate of 2.2 m x 3 mm) nor the thickness of the
// corner's block, which may be a splinter end on.
#pragma once

#include <limits>
#include <span>

#include "engine/contact/contact_set.h"
#include "engine/core/types.h"
#include "engine/model/model.h"
#include "engine/model/state.h"
#include "engine/simulation/excavated.h"

namespace dda {

struct DepthInThickness {
  double depth = 0;              // m
  double share = 0;              // of the thickness
  int inner = -1, thinner = -1;  // the blocks: whose corner it is, and whose face
  Vec2 place = Vec2::Zero();     // of the corner, m
  double time = 0;               // s

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [depth, share, inner, thinner, place, time] = self;
    archive.blocks_or_none(inner, thinner);
    archive(depth, share, place, time);
  }
};

// Shares of the thickness: beyond the first a block may have passed; beyond the second the end of a run is no result.
inline constexpr double passing_share = 0.5;
inline constexpr double ruinous_share = 0.1;

// m: how far block `block` goes on behind its face through `face`, opposite to `normal`, the face's unit normal out of
// it; infinite where it does not.
double thickness_behind(const Model& model, const State& state, int block, const Vec2& face, const Vec2& normal);

// m, at most the least width of each block and of the thinnest: what corners are compared with before a face is asked.
struct LeastWidths {
  std::span<const double> of_blocks;
  double of_all = 0;
};

// Takes note of corners that are deeper, by the thickness that they are in, than any before. Blocks that came in over
// others did not get there through a face: their contacts are seated (join_blocks.h), and that depth is left out.
void note_depths_in_thickness(const Model& model, const State& state, const ContactSet& contacts,
                              const LeastWidths& widths, std::span<const CameInOver> came_in_over,
                              DepthInThickness& deepest);

}  // namespace dda
