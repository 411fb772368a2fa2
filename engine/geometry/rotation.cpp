#include "engine/geometry/rotation.h"

#include <cmath>

namespace dda {

Mat2 rotation(double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  Mat2 matrix;
  matrix << c, -s, s, c;
  return matrix;
}

Mat2 deformation_increment(const Vec6& dofs, double before) {
  Mat2 strain;
  strain << dofs[3], dofs[5] / 2, dofs[5] / 2, dofs[4];
  return rotation(dofs[2] - before) * (Mat2::Identity() + strain + strain * strain / 2) * rotation(before);
}

Mat2 deformation_increment(const Vec6& dofs) { return deformation_increment(dofs, dofs[2] / 2); }

}  // namespace dda
