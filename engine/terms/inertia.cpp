#include "dda/terms/inertia.h"

namespace dda {

Vec3 mean_squares(const AreaMoments& moments) { return Vec3(moments.xx, moments.yy, moments.xy) / moments.area; }

Vec3 deformed_mean_squares(const Vec3& mean_squares, const Mat2& deformation) {
  const Mat2 tensor =
      (Mat2() << mean_squares(0), mean_squares(2), mean_squares(2), mean_squares(1)).finished();
  const Mat2 deformed = deformation * tensor * deformation.transpose();
  return {deformed(0, 0), deformed(1, 1), deformed(0, 1)};
}

Mat6 mass_matrix(double mass, const Vec3& mean_squares, double strain_inertia) {
  const double xx = mean_squares(0);
  const double yy = mean_squares(1);
  const double xy = mean_squares(2);
  Mat6 m = Mat6::Zero();
  m(0, 0) = m(1, 1) = 1;
  m(2, 2) = xx + yy;
  m(2, 3) = m(3, 2) = -xy;
  m(2, 4) = m(4, 2) = xy;
  m(2, 5) = m(5, 2) = (xx - yy) / 2;
  m.bottomRightCorner<3, 3>() << xx, 0, xy / 2,  //
      0, yy, xy / 2,                             //
      xy / 2, xy / 2, (xx + yy) / 4;
  m.bottomRightCorner<3, 3>() *= strain_inertia;
  return mass * m;
}

}  // namespace dda
