// One element of a lining: a straight Timoshenko beam between two faces of a wall, in its three natural modes (Argyris
// 1964, Recent advances in matrix methods of structural analysis).
//
// The gaps are the elongation of the chord, the turn of its end against its start, and the mean turn of both ends
// against the chord. For a beam that is loaded at its ends alone the strain energy is the sum of
//   E A/L e^2/2,  E I/L s^2/2,  12 E I/(L (1 + f)) a^2/2  with  f = 12 E I/(k G A L^2),
// so that stiffness is diagonal, and the forces conjugate to the gaps are the axial force N, the mean bending moment M
// and Q = V L, with the shear force V. The moment goes from M - Q/2 at the start to M + Q/2 at the end. A moment is
// positive that bends the beam to its left, towards the rock: it pulls the free face.
#pragma once

#include "engine/core/types.h"

namespace dda {

using Mat36 = Eigen::Matrix<double, 3, 6>;

// Gaps = a d_a + b d_b.
struct LiningRows {
  Mat36 a = Mat36::Zero(), b = Mat36::Zero();
};

// Where an element holds on to a block.
struct LiningGrip {
  Vec2 arm = Vec2::Zero();       // m, from the block's centroid
  Vec2 tangent = Vec2::UnitX();  // unit, along the face
};

// Stiffness of a section per m of thickness out of the plane. It is bent in plane strain.
struct LiningSection {
  double axial = 0;    // N: E A
  double bending = 0;  // N m: E I
  double shear = 0;    // N: k G A, k = 5/6
};

LiningSection lining_section(double thickness, double young, double poisson);

// N/m, N m and N m: of the three gaps.
Vec3 lining_stiffness(const LiningSection& section, double length);

// By which angle `to` lies counter-clockwise from `from`, above -pi up to pi.
double angle_between(const Vec2& from, const Vec2& to);

// `chord`: from the grip on block a to that on block b, m.
LiningRows lining_rows(const Vec2& chord, const LiningGrip& a, const LiningGrip& b);

}  // namespace dda
