// The traction between two blocks that may slide on each other, along an edge that they shared when drawn.
#pragma once

#include <optional>

#include "engine/contact/contact_set.h"
#include "engine/geometry/segment.h"
#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

struct SharedEdge {
  int block = 0;
  int other = 0;
  Segment edge;  // of `block`, as drawn, with the block on its left
};

// The edge of `block` at `point` along which `other` runs as well; none if they do not touch there along a stretch.
std::optional<SharedEdge> shared_edge(const Model& model, int block, int other, const Vec2& point);

// Mean normal and shear traction, Pa, tension positive, shear as in mean_traction: the contact forces between the two
// blocks on that edge over the length that they have in common now. Zero where they have none left.
Vec2 traction_along(const Model& model, const State& state, const ContactSet& contacts, const SharedEdge& shared);

}  // namespace dda
