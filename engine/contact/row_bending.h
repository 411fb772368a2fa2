// Bending of rows one block wide under the consistent law.
//
// Blocks have one strain each and do not bend: a beam of them turns in its joints. Of n rows of blocks across, the
// normal forces in the middles of the joints make 1 - 1/n^2 of the moment, and the difference of the normal gap between
// the ends of each joint the rest, (3 `stabilisation`)/n^2 of it. In a row one block wide, n = 1, that difference is
// all there is. A beam of bending stiffness E I turns by theta between the centroids of two blocks under the moment
//   M = theta/(d_a/(E I)_a + d_b/(E I)_b),     d: distance of a centroid from the joint, I = (width)^3/12,
// half blocks in series, E the modulus with free sides. Half of the difference of the gap is g = theta l/2, l the
// length of the joint, so its stiffness is 4/l^2 times that of theta: E l/(3 d) with d = d_a + d_b for equal blocks.
#pragma once

#include "engine/contact/contact_set.h"
#include "engine/model/model.h"

namespace dda {

// Faces of a block in a row count as opposite where their normals are within 25 degrees of each other (their cosine is
// at least this), as those of the voussoirs of an arch are.
inline constexpr double opposite_faces = 0.9;

// E I of a section, N m per m of thickness.
double bending_of_section(const Material& material, double width);

// Gives the joints of such rows this stiffness, of half the difference of the normal gap between their ends: joints
// whose blocks both have one joint at most on each of two opposite faces, none beside them, and a cross-section that
// hardly changes. Distances and widths are those along each block's own axis, against which joints may lean, as those
// of a ring of voussoirs do. Held blocks are rigid, whatever touches them.
//
// One of the two blocks is enough: where a row grows out of a mesh, meets another row or turns a corner its moment
// passes through the joint at its root alone. There the other block gives way as the edge of a half plane does.
//
// Between such a row and a mesh, which has that of `stabilisation`, the stiffness goes over as neighbours at the sides
// grow: a thin layer glued along a beam leaves it nearly what it is, and what hangs at one block of it alone all of
// that. A block that holds both blocks of a joint bears moments in place of the joint.
//
// Joints are here what holds blocks together: bonded or with strength, and not broken. Contacts that press and rub, and
// those of a corner, do not keep a row from bending by itself. Rows that are left where blocks are removed are asked
// for again then: their blocks bend from there on, for what they are bent already as well.
void stiffen_rows(const Model& model, ContactSet& contacts);

}  // namespace dda
