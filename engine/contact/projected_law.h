// The projected law: a joint that carries traction as a bonded one while it is closed and sticks, and that opens and
// slides by that traction (after Chouly, Hild & Renard 2015, theta = 1, penalised against each block's own traction).
//
//   V = W + sum over stretches of l max over the traction T of
//         [ T . g - |T - t_a|^2/(4 gamma_a) - |T - t_b|^2/(4 gamma_b) - T . C T/2 ],   t = sigma n
//
// W: strain energy of the blocks, g: gap, C: compliance of the joint itself, where it has one. The maximum is that of a
// spring with a shifted gap,
//
//   g' = g + t_a/(2 gamma_a) + t_b/(2 gamma_b),   T = k g',   1/k = 1/(2 gamma_a) + 1/(2 gamma_b) + C
//
// less -l/(4 gamma) |t|^2 for either block, which is the block's own (ContactSet::outline_compliance). Opening,
// friction and strength bound T, so they judge the traction that the joint carries. Stresses are total ones, in-situ
// stress included. A held block knows of no stress: only the other's counts. Where a load acts on the face of a block,
// as the pressure of water in a joint does, the joint carries what the block's stress has beyond it: t is less by the
// load (simulation/face_loads.h).
//
// gamma = penalty D/w: D the plane modulus, w the width of the block across the joint. The sum is convex when the
// penalty of each block is above the largest eigenvalue of (sum over its outline of l w/(2 D) R^T R) x = lambda A D x,
// R giving its traction by its strains: 1 + nu for rectangles in plane stress, 1.8 to 2 in nearly incompressible plane
// strain, up to 3 for triangles. Lengths of stretches drop out, so blocks may meet along slivers. There gamma is
// larger: rock gives way under a load on a small part of its side by about the length of that part and not by its whole
// width, and a sliver would sink into a large block. So w is less in proportion where the stretch is shorter than
// `spreading_share` of the block's side, which leaves a stiffness that no longer falls with the length.
//
// Blocks of uniform strain do not bend. A closed stretch therefore acts at two points at -lever and +lever of half its
// length from the middle, where the stiffness of its turn is that of two half columns; opened in part it answers as a
// column without tension, but for a closed part of less than `spreading_share` of the blocks' sides, as above, or of
// half of their depth, where that is more (no_tension_bed.h). Where the blocks differ that share is the mean by what
// either adds to the bed's compliance; the joint's own material spreads nothing.
#pragma once

#include <algorithm>
#include <array>

#include "engine/contact/interface_element.h"
#include "engine/contact/no_tension_bed.h"
#include "engine/model/model.h"

namespace dda {

using Mat23 = Eigen::Matrix<double, 2, 3>;

// The least penalty makes a free bar of equal blocks correct to fourth order (ADR 24).
inline constexpr double least_penalty = 3;

// penalty = max(least_penalty, penalty_margin lambda)
inline constexpr double penalty_margin = 2;

// A stretch of this share of the block's side or more loads it as a whole, as half a side does in running bond.
inline constexpr double spreading_share = 0.25;

// The eigenvalue lambda above, over the whole outline: no stretch has more.
double largest_traction_share(const Model& model, int block);

// The penalty of a block, without units.
double projected_penalty(const Model& model, int block);

// 1/(2 gamma) of both blocks, m/Pa: an eigenvalue of each block, so it is asked once for a stretch.
Vec2 projected_softness(const Model& model, const Interface& interface);

// The stiffness of a stretch's four rows, N/m per m of thickness, and the lever of its points, with that softness.
Vec4 projected_stiffness(const Model& model, const Interface& interface, const Vec2& softness);
double projected_lever(const Model& model, const Interface& interface, const Vec2& softness);

// The closed part of a stretch, over its length, below which its bed is stiffer than a column (no_tension_bed.h).
double projected_spread(const Model& model, const Interface& interface);

// What a block's weight makes of its stress between its centroid and the middle of a stretch, as the traction there,
// Pa: normal and shear, by the directions of the drawing.
Vec2 traction_by_weight(const Model& model, int block, const Interface& interface);

// Brings the same of both blocks to an element of this law, without what loads on its faces add to it.
void set_weights(const Model& model, const Interface& interface, InterfaceElement& element);

// Fills all of these, and the weights, of an element of this law.
void set_projected_springs(const Model& model, const Interface& interface, InterfaceElement& element);

// Fills the rows of an element of this law.
void set_projected_rows(const Model& model, const InterfaceFrame& frame, InterfaceElement& element);

// What the stresses of both blocks (Pa) add to the normal and to the tangential gap of a stretch, m.
Vec2 gap_by_stress(const Vec2& softness, const Vec2& normal, const Vec3& stress_a, const Vec3& stress_b);

// How deep the blocks of a stretch are in each other, m: its gaps less what their stresses make of them.
double projected_depth(const InterfaceElement& element, const Vec4& gap, const Vec3& stress_a, const Vec3& stress_b);

// Normal and shear force at either end of a stretch that have the same sum and moment as those at its points.
std::array<Vec2, 2> forces_at_ends(const InterfaceSprings& springs, const Vec4& force);

inline Bed bed_of(const InterfaceSprings& springs) { return {springs.stiffness(0), springs.lever, springs.spread}; }

// Broken stretches of this law press as a whole, and not end by end.
inline bool press_together(const InterfaceSprings& springs, const std::array<bool, 2>& broken) {
  return springs.law == InterfaceLaw::projected && broken[0] && broken[1];
}

// Whether one does, though an end may gape, with these forces of its four rows.
inline bool presses_together(const InterfaceSprings& springs, const std::array<bool, 2>& broken, const Vec4& force) {
  return press_together(springs, broken) && (force(0) < 0 || force(2) < 0);
}

// The normal force by which the friction of an end of a stretch goes, by the forces of the four rows. Where the stretch
// is open beyond one of its points, the other has more than all of the force and this one pulls: that one then has what
// there is of both, this one nothing.
inline double pressing_force(const Vec4& force, int end) {
  return std::min(0.0, force(2 * end) + std::max(0.0, force(2 - 2 * end)));
}

// How that force follows the normal gaps of both points (N/m per m of thickness), by how the normal forces of the
// points (rows of `by_gaps`) do.
inline Vec2 pressing_slope(const Vec4& force, const Mat2& by_gaps, int end) {
  if (pressing_force(force, end) == 0) return Vec2::Zero();
  return force(2 - 2 * end) > 0 ? Vec2(by_gaps.colwise().sum()) : Vec2(by_gaps.row(end));
}

// What stretches take off a block of the stress s (Pa): the energy -(s . compliance s/2 + strain . s + energy), per m
// of thickness.
struct TakenOff {
  Mat3 compliance = Mat3::Zero();  // m3/N
  Vec3 strain = Vec3::Zero();      // m2
  double energy = 0;               // N
};

// By a stretch that has this softness in the block, and this traction there beside that of the block's stress. The
// normal is that of now.
TakenOff taken_off(const InterfaceElement& element, double softness, const Vec2& beside_stress);

}  // namespace dda
