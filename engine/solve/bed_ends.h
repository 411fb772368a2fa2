// A projected stretch on its bed (no_tension_bed.h), as interior passes see it.
//
// What presses within the stretch is a sum of two pressures at its ends, p > 0 of both, whatever is closed; so the
// forces that the bed can answer with are those of two normal rows, and end rows take the place of the rows of its two
// points. With the openings e of the ends and the potential W of the bed,
//   e + c(p) = s,   p . s -> 0,   c = what the bed gives way at both ends under p, the gradient of W's conjugate
// which is f/k = c of a lone spring, but for c's not being linear where a part of the stretch gapes and for either
// end's knowing of both pressures. It is a gradient of a convex function all the same, and s vanishes at both ends
// unless the whole stretch is open: one that gapes has a small pressure at the end that does.
#pragma once

#include "engine/contact/no_tension_bed.h"
#include "engine/core/types.h"

namespace dda {

// How far the ends of the stretch are open where its points have these gaps, m; and the pressures at its ends that are
// the same as these forces at its points, N per m of thickness, and back.
[[nodiscard]] Vec2 openings_of_ends(double lever, const Vec2& gaps);
[[nodiscard]] Vec2 pressures_of_ends(double lever, const Vec2& forces);
[[nodiscard]] Vec2 forces_of_points(double lever, const Vec2& pressures);

// Whether so little is closed under these pressures that the bed gives way as a spring at its end: it then turns as it
// likes, and does not give way further as it does.
[[nodiscard]] bool is_taken_for_a_spring(const Vec2& pressures);

struct Compression {
  Vec2 depth;     // c, m
  Mat2 softness;  // dc/dp, m2/N
};

// Under pressures at both ends, all of them > 0.
[[nodiscard]] Compression compress(const Bed& bed, const Vec2& pressures);

// How the forces of the points follow their gaps, N/m per m of thickness, where the pressures of the ends fall by this
// stiffness as the ends open.
[[nodiscard]] Mat2 slopes_of_points(double lever, const Mat2& stiffness);

}  // namespace dda
