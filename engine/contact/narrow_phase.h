// Narrow phase: which vertices of one block touch, or nearly touch, which edges of another.
//
// They are the covers on the outline of the two blocks' entrance block near the place taken now (entrance_cover.h):
// those behind which the blocks really overlap (real_overlap.h), and at its corners those that keep them apart
// (cover_corners.h). Edge-edge contact is two of them, one at each end of the common stretch.
#pragma once

#include <functional>
#include <vector>

#include "engine/contact/cover_corners.h"
#include "engine/contact/entrance_cover.h"
#include "engine/contact/outlines.h"
#include "engine/contact/vertex_contact.h"

namespace dda {

// One for each thread: it keeps the memory that pairs need in turn.
class NarrowPhase {
 public:
  explicit NarrowPhase(const Outlines& outlines) : outlines_(outlines) {}

  // Appends the contacts between blocks `a` and `b`.
  void find(int a, int b, const CoverRange& range, std::vector<VertexContact>& found);

  // The same as if the covers that `is_out` says so of were not there.
  void find(int a, int b, const CoverRange& range, const std::function<bool(const VertexContact&)>& is_out,
            std::vector<VertexContact>& found);

 private:
  void choose(const CoverRange& range, std::vector<VertexContact>& found);

  const Outlines& outlines_;
  std::vector<Cover> covers_;
  std::vector<Cover*> pressed_;
  std::vector<CoverEnd> ends_;
};

}  // namespace dda
