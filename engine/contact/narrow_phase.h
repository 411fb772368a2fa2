// Narrow phase: which vertices of one block touch, or nearly touch, which edges of another.
//
// They are the covers on the outline of the two blocks' entrance block near the place taken now (entrance_cover.h):
// those behind which the blocks really overlap (real_overlap.h), and at its corners those that keep them apart
// (cover_corners.h). Edge-edge contact is two of them, one at each end of the common stretch.
#pragma once

#include <functional>
#include <vector>

#include "engine/contact/outlines.h"
#include "engine/contact/vertex_contact.h"

namespace dda {

// Contacts between blocks `a` and `b` with gaps from -`depth` to `reach` (m). Gaps and places on edges that differ by
// less than `round_off` (m) are the same.
void find_vertex_contacts(const Outlines& outlines, int a, int b, double reach, double depth, double round_off,
                          std::vector<VertexContact>& found);

// The same as if the covers that `is_out` says so of were not there.
void find_vertex_contacts(const Outlines& outlines, int a, int b, double reach, double depth, double round_off,
                          const std::function<bool(const VertexContact&)>& is_out, std::vector<VertexContact>& found);

}  // namespace dda
