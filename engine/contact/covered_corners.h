// Contacts of two corners that cannot be: a third block is in the way.
//
//        |  A   |  B          A is pressed against B, and B's side goes on in that of D. So A's corner v lies deeper
//        than D's |      v____         corner w, by as much as springs give way, and as the pair sees it, on top of D.
//        But A has
//        |______w____         come along the common side of B and D, and its corner passes w. In the same way D cannot
//           C   |  D          hit A's side where C carries D in line with it.
//
// The same goes for a corner that slides along B on to D, within a step: on its way it meets no side of D.
//
// Left in, such contacts hang a block of a regular grid up on its neighbours, whatever the friction.
//
// That holds for where the blocks are. A step that opens the joints between moves such corners into each other all the
// same: they are looked at with its motion, and count as contacts from then on if so.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "engine/contact/contact_search.h"
#include "engine/contact/outlines.h"
#include "engine/contact/vertex_contact.h"

namespace dda {

// Where a block carries another: a contact, or an end of a joint that holds.
struct Carrier {
  int block_a = 0, block_b = 0;
  Vec2 point;      // m
  Vec2 normal;     // unit, out of a into b
  double gap = 0;  // m
};

// Sides are in line, and corners on each other, up to this share of the smaller block's size: a tenth of the
// penetration that a run warns of.
inline constexpr double in_line = 1e-3;

// Takes them out of `found`, which stays sorted, and returns them. `size`: of each block, m. `joints`: carriers besides
// `found`. Those between the pairs of blocks `uncovered` (smaller first, sorted) stay.
std::vector<VertexContact> take_out_covered(const ContactSearch& search, const std::vector<Carrier>& joints,
                                            const std::vector<std::pair<int, int>>& uncovered,
                                            std::vector<VertexContact>& found);

// The pairs (smaller first, sorted) whose corners, covered at the start of a step, are deeper in each other than
// `in_line` says after increments `d` (6 a block) of `state`, in which `outlines` are.
std::vector<std::pair<int, int>> pressed_into_each_other(const Outlines& outlines, const std::vector<double>& size,
                                                         const std::vector<VertexContact>& covered, const Model& model,
                                                         const State& state, const Eigen::VectorXd& d);

}  // namespace dda
