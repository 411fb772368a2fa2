#include "engine/terms/inertia.h"

namespace dda {

Vec3 mean_squares(const AreaMoments& moments) { return Vec3(moments.xx, moments.yy, moments.xy) / moments.area; }

Vec3 deformed_mean_squares(const Vec3& mean_squares, const Mat2& deformation) {
  const Mat2 tensor = (Mat2() << mean_squares(0), mean_squares(2), mean_squares(2), mean_squares(1)).finished();
  const Mat2 deformed = deformation * tensor * deformation.transpose();
  return {deformed(0, 0), deformed(1, 1), deformed(0, 1)};
}

Mat6 mass_matrix(const Inertia& inertia) {
  Mat6 mass;
  for (int column = 0; column < 6; ++column) mass.col(column) = momentum(inertia, Vec6::Unit(column));
  return mass;
}

}  // namespace dda
