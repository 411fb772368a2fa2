#include "engine/terms/viscous_boundary.h"

#include <cmath>

namespace dda {

Mat6 viscous_damping(const Vec2& from, const Vec2& to, double normal_impedance, double shear_impedance) {
  return viscous_coupling(from, to, from, to, normal_impedance, shear_impedance);
}

Mat6 viscous_coupling(const Vec2& from, const Vec2& to, const Vec2& other_from, const Vec2& other_to,
                      double normal_impedance, double shear_impedance) {
  const double length = (to - from).norm();
  const Vec2 along = (to - from) / length;
  const Mat2 tangential = along * along.transpose();
  const Mat2 impedance = normal_impedance * (Mat2::Identity() - tangential) + shear_impedance * tangential;
  Mat6 coupling = Mat6::Zero();
  for (const double sign : {-1.0, 1.0}) {
    const double share = sign / (2 * std::sqrt(3.0));  // of the edge, from its middle
    const Mat26 rows = displacement_rows((from + to) / 2 + share * (to - from));
    const Mat26 other_rows = displacement_rows((other_from + other_to) / 2 + share * (other_to - other_from));
    coupling += length / 2 * rows.transpose() * impedance * other_rows;
  }
  return coupling;
}

}  // namespace dda
