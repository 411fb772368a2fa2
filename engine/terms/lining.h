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

#include <cmath>

#include "engine/core/types.h"
#include "engine/geometry/segment.h"

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

inline LiningSection lining_section(double thickness, double young, double poisson) {
  const double plane_modulus = young / (1 - poisson * poisson);
  const double shear_modulus = young / (2 * (1 + poisson));
  return {plane_modulus * thickness, plane_modulus * thickness * thickness * thickness / 12,
          5.0 / 6 * shear_modulus * thickness};
}

// N/m, N m and N m: of the three gaps.
inline Vec3 lining_stiffness(const LiningSection& section, double length) {
  const double flexible_in_shear = 12 * section.bending / (section.shear * length * length);
  return {section.axial / length, section.bending / length, 12 * section.bending / (length * (1 + flexible_in_shear))};
}

// By which angle `to` lies counter-clockwise from `from`, above -pi up to pi.
inline double angle_between(const Vec2& from, const Vec2& to) { return std::atan2(cross(from, to), from.dot(to)); }

// The turn of a material line along `t` with the six unknowns of its block: n . grad(u) t, with n on its left.
inline Eigen::Matrix<double, 1, 6> turn_row(const Vec2& t) {
  Eigen::Matrix<double, 1, 6> row;
  row << 0, 0, 1, -t.x() * t.y(), t.x() * t.y(), (t.x() * t.x() - t.y() * t.y()) / 2;
  return row;
}

// Its stretch: t . grad(u) t.
inline Eigen::Matrix<double, 1, 6> stretch_row(const Vec2& t) {
  Eigen::Matrix<double, 1, 6> row;
  row << 0, 0, 0, t.x() * t.x(), t.y() * t.y(), t.x() * t.y();
  return row;
}

// `chord`: from the grip on block a to that on block b, m.
//
// Where the wall bends by w from a to b, a stretch of the wall that grows by g on the way turns the chord by g w/12
// without bending anything: the chord of a curve turns with (1/L) times the integral of stretch * sin(angle to the
// chord). Without this the shear force in a round lining would not converge, since it is the third derivative of what
// the rock imposes.
inline LiningRows lining_rows(const Vec2& chord, const LiningGrip& a, const LiningGrip& b) {
  const double length = chord.norm();
  const Vec2 along = chord / length;
  const Vec2 across(-along.y(), along.x());
  const double bend = angle_between(a.tangent, b.tangent) / 12;
  const Mat26 move_a = displacement_rows(a.arm);
  const Mat26 move_b = displacement_rows(b.arm);
  LiningRows rows;
  rows.a << -along.transpose() * move_a, -turn_row(a.tangent),
      turn_row(a.tangent) / 2 + across.transpose() * move_a / length - bend * stretch_row(a.tangent);
  rows.b << along.transpose() * move_b, turn_row(b.tangent),
      turn_row(b.tangent) / 2 - across.transpose() * move_b / length + bend * stretch_row(b.tangent);
  return rows;
}

}  // namespace dda
