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
//
// That is a column's answer down to a line, where it gives way without bound. Rock that is loaded over a small part of
// its side gives way by about the length of that part, and by little more when the part gets smaller (as the logarithm
// of it, under a strip). So below a closed part `spread` = a0 of the stretch the bed is stiffer than the column, and at
// last a spring at the end, of stiffness bed K a0 spread_rise/2. With x = a/a0, c = 1 - bed:
//   N = -bed K |T| n,  M = T (2 h + r bed K n),  h = bed K integral of n du,  u = 1 - r = 2 a - c a^2
//   n = a0^2 (x^2 + spread_rise x (1 - x)^2 (1 - q x^3)),  q = 14 (5 - 2 c a0)/(8 - 5 c a0)
// n = a^2 would be the column. At a0 forces and slopes are continuous; q is what leaves h, and so the moment, the
// column's there. W = T^2 h is convex where the root of h is, 2 h h'' >= h'^2: how far `spread_rise` may go. The
// stiffest bed that is convex at all has 2/3; it turns about one place whatever the force, and its force jumps at a0.
// All of it is written in the gaps at two points at -lever and +lever of half the length from the middle, where a
// closed joint is two springs K/2 that do not know of each other.
#pragma once

#include "engine/core/types.h"

namespace dda {

// Convex up to 0.44 at least, for every bed and spread.
inline constexpr double spread_rise = 0.4;

struct Bed {
  double stiffness = 0;  // N/m per m of thickness, of each point while the joint is closed, K/2
  double lever = 1;
  double spread = 0;  // the closed part, of the length, below which the bed is stiffer than a column; at most 1
};

struct BedAnswer {
  Vec2 force;       // N per m of thickness at either point, tension positive
  Vec2 slope;       // N/m per m of thickness, of each force by its own gap
  double coupling;  // N/m per m of thickness, of either force by the other gap
};

BedAnswer press_bed(const Bed& bed, const Vec2& gaps);

// The mean of what the bed answers on the straight way from some gaps to others, and how it follows the latter: the
// work of the mean is the change of the potential, whatever opens or closes on the way, and its slopes are those of a
// convex potential too. By quadrature between the places where the answer changes its formula: the work is off by up to
// 1e-6 of stiffness times gaps squared on ways as long as the gaps, and far less on shorter ones.
BedAnswer mean_of_bed(const Bed& bed, const Vec2& from, const Vec2& to);

// The gaps at which the bed answers with these forces of the two points, which press together.
Vec2 gaps_of_bed(const Bed& bed, const Vec2& force);

// Which ends of the stretch gape at these gaps of the two points: that at the first, at the second.
struct OpenEnds {
  bool first = false, second = false;
  [[nodiscard]] bool operator==(const OpenEnds&) const = default;
};
OpenEnds open_ends(double lever, const Vec2& gaps);

// The part of the stretch on which these forces of its points press, of its length, and how that follows the normal
// gaps of both, 1/m, by how the forces (rows of `by_gaps`) do. It is what equilibrium leaves a joint without tension,
// three times the distance of the resultant from the edge that it is nearest to, and so a of the header of a bed that
// is a column. Gaps tell another where a bed spreads its load: they are how the rock yields, and no measure of the face
// that bears. 0 where nothing presses, 1 where no end gapes.
double closed_share(double lever, const Vec2& force);
Vec2 closed_share_by_gaps(double lever, const Vec2& force, const Mat2& by_gaps);

// How far the stretch lies in its neighbour at the end where it does most, beyond the points, m; not positive where it
// is open.
double deepest_end(double lever, const Vec2& gaps);

}  // namespace dda
