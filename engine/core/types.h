// Fixed-size linear algebra of the engine. SI units everywhere; frame: x right, y up, angles counter-clockwise.
#pragma once

#include <Eigen/Core>

namespace dda {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;  // a symmetric 2x2 tensor as (xx, yy, xy); for strain the third entry is gamma_xy
using Mat2 = Eigen::Matrix2d;
using Mat3 = Eigen::Matrix3d;

// The six unknowns of a block, in this order everywhere: translation of the centroid (u0, v0) in m, rotation r0 in rad,
// strains (ex, ey, gxy) with gxy the engineering shear strain. Forces conjugate to them have the same order.
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using Mat26 = Eigen::Matrix<double, 2, 6>;

// First-order displacement field of a block (Shi 1988): u(x) = displacement_rows(x - centroid) * dofs.
inline Mat26 displacement_rows(const Vec2& offset) {
  Mat26 rows;
  rows << 1, 0, -offset.y(), offset.x(), 0, offset.y() / 2,  //
      0, 1, offset.x(), 0, offset.y(), offset.x() / 2;
  return rows;
}

// Force per area that a stress (xx, yy, xy) exerts on a surface with this outward unit normal.
inline Vec2 traction_on(const Vec3& stress, const Vec2& normal) {
  return {stress(0) * normal.x() + stress(2) * normal.y(), stress(2) * normal.x() + stress(1) * normal.y()};
}

}  // namespace dda
