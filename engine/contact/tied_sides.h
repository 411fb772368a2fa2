// Blocks whose sides are tied, as those of columns beside free-field sides: each stands for an endless row of equal
// blocks, and where these have projected joints between them the tie is that joint, of the block with itself.
//
// The model says so by the joint of the pair (block, block) in `joint_of_block_pair`. With g the way between the tied
// points and the law's gap g' = g - 2 s t, 2 s the softness of both blocks of a joint and t the block's own traction,
// the tie carries k g' and the block loses 2 s l t^2/2, as with projected_law.h. What the block loses the tie gives it
// where the points do not move apart; where they do, by what stresses above and below leave, the block gives way as
// those of the row do.
#pragma once

#include <optional>

#include "engine/contact/contact_set.h"
#include "engine/contact/projected_law.h"
#include "engine/model/model.h"

namespace dda {

struct TiedSides {
  double length = 0;              // m, of a side
  double softness = 0;            // m/Pa, of both blocks of the joint
  Vec2 stiffness = Vec2::Zero();  // N/m, across the joint and along it
};

// The joint of the law that a block has with itself, between sides with this normal; none where it has none. For a
// block with its moments.
std::optional<TiedSides> tied_sides(const Model& model, int block, const Vec2& normal);

// The same of the sides that a spring between two points of a block ties.
std::optional<TiedSides> tied_sides(const Model& model, const PointSupport& tie);

// What a stress of the block, Pa, makes of the way that the spring goes by, m.
Mat23 gap_by_stress(const TiedSides& sides, const PointSupport& tie);

// What projected stretches take off each block, and what these joints do.
void take_off_blocks(const Model& model, ContactSet& contacts);

}  // namespace dda
