#include "engine/terms/lining.h"

#include <cmath>

#include "engine/geometry/segment.h"

namespace dda {
namespace {

using Row6 = Eigen::Matrix<double, 1, 6>;

// The turn of a material line along `t` with the six unknowns of its block: n . grad(u) t, with n on its left.
Row6 turn_row(const Vec2& t) {
  Row6 row;
  row << 0, 0, 1, -t.x() * t.y(), t.x() * t.y(), (t.x() * t.x() - t.y() * t.y()) / 2;
  return row;
}

// Its stretch: t . grad(u) t.
Row6 stretch_row(const Vec2& t) {
  Row6 row;
  row << 0, 0, 0, t.x() * t.x(), t.y() * t.y(), t.x() * t.y();
  return row;
}

}  // namespace

LiningSection lining_section(double thickness, double young, double poisson) {
  const double plane_modulus = young / (1 - poisson * poisson);
  const double shear_modulus = young / (2 * (1 + poisson));
  return {plane_modulus * thickness, plane_modulus * thickness * thickness * thickness / 12,
          5.0 / 6 * shear_modulus * thickness};
}

Vec3 lining_stiffness(const LiningSection& section, double length) {
  const double flexible_in_shear = 12 * section.bending / (section.shear * length * length);
  return {section.axial / length, section.bending / length, 12 * section.bending / (length * (1 + flexible_in_shear))};
}

double angle_between(const Vec2& from, const Vec2& to) { return std::atan2(cross(from, to), from.dot(to)); }

// Where the wall bends by w from a to b, a stretch of the wall that grows by g on the way turns the chord by g w/12
// without bending anything: the chord of a curve turns with (1/L) times the integral of stretch * sin(angle to the
// chord). Without this the shear force in a round lining would not converge, since it is the third derivative of what
// the rock imposes.
LiningRows lining_rows(const Vec2& chord, const LiningGrip& a, const LiningGrip& b) {
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
