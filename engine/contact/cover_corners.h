// Which covers count where the entrance block has a corner: where a vertex of one block meets a vertex of the other.
//
// The covers that end in a corner go on beyond it, and a step may lead over it. At a convex corner the blocks are apart
// as soon as one cover says so: the one with the largest gap counts, and where the foreseen motion of the step closes
// gaps the one that stays open, or is the last to close: that is what the blocks meet. A block that slides off a ledge
// would hit the upright side of a block further down that it passes over within the step. At a reflex corner, which a
// vertex in a notch makes, they are apart only if both say so: both count. Two covers in line, of corners above each
// other, are one, and so are the ends of a common stretch that is shorter than the blocks are pressed in. What is equal
// but for round-off is never settled by an order: other covers that keep the blocks apart as long both count.
#pragma once

#include <utility>
#include <vector>

#include "engine/contact/entrance_cover.h"

namespace dda {

// One end of a cover, as translations of the block with the lower number see it.
struct CoverEnd {
  std::pair<int, int> vertices;  // that meet there
  Cover* cover;
  int vertex;   // the one of the edge's block
  Vec2 along;   // from the end along the cover; not a unit vector
  Vec2 normal;  // unit, out of the entrance block

  [[nodiscard]] bool is_near() const { return cover->beyond <= 0 || cover->corner == vertex; }
  [[nodiscard]] double gap() const { return cover->contact.gap; }
};

// Takes out the covers that do not count. `reach`: m, as given to find_covers. `round_off`: m, gaps and
// stretches that count as none. `ends` is scratch.
void choose_at_corners(const Outlines& outlines, double reach, double round_off, std::vector<Cover>& covers,
                       std::vector<CoverEnd>& ends);

}  // namespace dda
