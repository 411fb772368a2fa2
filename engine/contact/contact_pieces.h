// The linear pieces of what an interface answers to a gap when capacities follow normal forces, and the way that
// Newton's method takes between them.
//
// An end is open, sticks or slides to one of two sides, and is linear in its gaps while it does. In the order
//   slides back - sticks - slides forth, with open bordering on both ends of the row
// the answer is continuous from each piece to the next. An end without capacity, be it that it has no friction or that
// a projected stretch gapes there, slides freely: it counts as open, and does not stick on the way from one side to the
// other.
#pragma once

#include <array>
#include <cstdint>

#include "engine/contact/open_close.h"

namespace dda {

enum class ContactPiece : std::int8_t { open, stuck, slides_forth, slides_back };
inline bool slides(ContactPiece piece) {
  return piece == ContactPiece::slides_forth || piece == ContactPiece::slides_back;
}
inline double direction_of(ContactPiece piece) { return piece == ContactPiece::slides_forth ? 1 : -1; }

using ContactPieces = std::array<ContactPiece, 2>;

ContactPieces pieces_of(const InterfaceTrial& trial);

struct PieceRule {
  bool strict = false;
  double negligible_force = 0;  // N per m of thickness
};

// Says on which pieces the next pass takes the ends to be; `pieces` come as those of the pass before.
//
// An end that has left its piece for one that does not border on it is laid on the one between: no slip turns without
// sticking, nor, if the rule is strict, does an end close and stick at once or open before it slides. Newton's method
// goes in circles otherwise. Its forces are then not what the end answers, which returns true. An end for which the old
// piece makes no more than a negligible difference stays on it: where blocks just touch, ends would hop for ever.
bool keep_to_bordering_pieces(const InterfaceSprings& springs, const EndStrength& strength, const PieceRule& rule,
                              InterfaceTrial& trial, ContactPieces& pieces);

// Lays the ends on these pieces, whatever the gap: where the trial answers otherwise, forces are not what the ends
// answer, which returns true. Where pieces are not linear the trial keeps its answer, and `pieces` say which that is.
bool stay_on_pieces(const InterfaceSprings& springs, const EndStrength& strength, const PieceRule& rule,
                    InterfaceTrial& trial, ContactPieces& pieces);

// Slopes of the shear forces of both ends (rows) over their normal gaps (columns) that capacities make where ends slide
// (N/m per m of thickness); 0 elsewhere, and where capacities are given. Ends that press each for itself leave the
// other's gap out.
Mat2 shear_by_normal_gap(const InterfaceSprings& springs, const EndStrength& strength, const InterfaceTrial& trial,
                         const ContactPieces& pieces);

}  // namespace dda
