// Contacts of two corners that cannot be: a third block is in the way.
//
//        |  A   |  B        A is pressed against B, whose side ends where D's begins. So A's
//        |      v____       corner v lies deeper than D's corner w, by as much as springs give
//        |______w____       way, and as the pair sees it, on top of D. But A has come along B,
//           C   |  D        and its corner passes w. What it can meet of D is what rises from w
//                           above the line of B's side, whether that is in line with D's or not.
//
// The covers of two blocks (entrance_cover.h) that meet where a corner of one is at a corner of the other lead away
// from there as the translations do that keep them in touch. A third block that carries one of the corners on a surface
// which leads through the other allows no translation into itself: covers that lead beneath its surface are out, and
// the contacts are chosen from the others. So a ramp that begins at the end of a floor is met as a ramp, though its
// block has an upright side there, and a wedge on the floor is ridden up. That counts where the corners are, or come to
// be within the step, and where the surface leads through the other corner then as well.
//
// Left in, such contacts hang a block of a regular grid up on its neighbours, whatever the friction, and stop what
// slides over joints.
//
// Two corners that third blocks carry on surfaces in line are kept off nothing by these: either block can leave the
// surface, and a block that slides down a joint stands on what ends there. Nor do corners carry that are covered.
//
// That holds for where the blocks are. A step that opens the joints between moves such corners into each other all the
// same: they are looked at with its motion, and count as contacts from then on if so.
#pragma once

#include <Eigen/Core>
#include <functional>
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
  double strain_jump =
      0;  // m, of a joint: how far its ends slide in or out because its blocks' strains along it differ
};

// Sides are in line, and corners on each other, up to this share of the smaller block's size: a tenth of the
// penetration that a run warns of.
inline constexpr double in_line = 1e-3;

// Takes them out of `found`, which stays sorted, and returns them. Others of the same blocks come in their place where
// a corner comes to an edge from some way off, or were among the `known` of the last search (sorted). `joints`:
// carriers besides `found`. Those between the pairs of blocks `uncovered` (smaller first, sorted) stay.
std::vector<VertexContact> take_out_covered(const ContactSearch& search, const std::vector<Carrier>& joints,
                                            const std::vector<std::pair<int, int>>& uncovered,
                                            const std::vector<VertexContact>& known, std::vector<VertexContact>& found);

// What strains have to do with where the corner of a block lies after a step, m; see strain_jump_at.
using JumpAt = std::function<double(int block, const Vec2& place, double near)>;

// The pairs (smaller first, sorted) whose corners, covered at the start of a step, are deeper in each other than
// `in_line` says, and strains, after increments `d` (6 a block) of `state`, the one of the last search.
std::vector<std::pair<int, int>> pressed_into_each_other(const ContactSearch& search,
                                                         const std::vector<VertexContact>& covered, const Model& model,
                                                         const State& state, const Eigen::VectorXd& d,
                                                         const JumpAt& jump_at);

}  // namespace dda
