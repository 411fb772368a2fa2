#include "dda/terms/viscous_boundary.h"

#include <cmath>

namespace dda {

Mat6 viscous_damping(const Vec2& from, const Vec2& to, double normal_impedance, double shear_impedance) {
  const double length = (to - from).norm();
  const Vec2 along = (to - from) / length;
  const Mat2 tangential = along * along.transpose();
  const Mat2 impedance = normal_impedance * (Mat2::Identity() - tangential) + shear_impedance * tangential;
  Mat6 damping = Mat6::Zero();
  for (const double sign : {-1.0, 1.0}) {
    const Vec2 point = (from + to) / 2 + sign / (2 * std::sqrt(3.0)) * (to - from);
    const Mat26 rows = displacement_rows(point);
    damping += length / 2 * rows.transpose() * impedance * rows;
  }
  return damping;
}

}  // namespace dda
