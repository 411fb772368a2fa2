// What a joint that carries no tension answers where it is closed in part.
//
// Two blocks that meet along a stretch turn against each other as the ends of two short columns do: sections stay
// plane, and the joint opens where it would be pulled. That is a bed of springs E/w an area (w: half of the height of
// both columns) that only press, and it bends as a column without tension does, which opens when the force leaves the
// middle third. Of the bed's compliance in the mean, blocks already have a part in their own strains: what is left to
// the gap of the law is the share `bed` = 3 lever^2 of it, see projected_law.h.
//
// With the mean G and half of the difference T of the gaps at the ends of the stretch, r = G/|T|, K the stiffness of
// the closed joint, and a the closed part of its length:
//   G <= -bed |T|   closed: N = K G, and the moment M = bed K T/3, conjugate to T
//   G >= |T|        open
//   between         N = -bed K |T| a^2,  M = bed K T a^2 (1 - 2 a/3),  r = 1 - 2 a + (1 - bed) a^2
// These are the slopes of one convex potential, which is of second degree in the gaps: its value is (G N + T M)/2.
// All of it is written in the gaps at two points at -lever and +lever of half the length from the middle, where a
// closed joint is two springs K/2 that do not know of each other.
#pragma once

#include "engine/core/types.h"

namespace dda {

struct BedAnswer {
  Vec2 force;       // N per m of thickness at either point, tension positive
  Vec2 slope;       // N/m per m of thickness, of each force by its own gap
  double coupling;  // N/m per m of thickness, of either force by the other gap
};

// `stiffness`: of each point while the joint is closed, K/2.
BedAnswer press_bed(double stiffness, double lever, const Vec2& gaps);

// Which ends of the stretch gape at these gaps of the two points: that at the first, at the second.
struct OpenEnds {
  bool first = false, second = false;
};
OpenEnds open_ends(double lever, const Vec2& gaps);

// How far the stretch lies in its neighbour at the end where it does most, beyond the points, m; not positive where it
// is open.
double deepest_end(double lever, const Vec2& gaps);

}  // namespace dda
