#include "engine/model/material.h"

#include <cmath>

namespace dda {

Mat3 elasticity_matrix(const Material& material) {
  const double nu = material.poisson;
  const double shear = material.young / (2 * (1 + nu));
  const bool plane_stress = material.plane == PlaneState::stress;
  const double direct =
      plane_stress ? material.young / (1 - nu * nu) : material.young * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
  const double cross = direct * (plane_stress ? nu : nu / (1 - nu));
  return (Mat3() << direct, cross, 0, cross, direct, 0, 0, 0, shear).finished();
}

double bar_wave_speed(const Material& material) {
  const bool plane_stress = material.plane == PlaneState::stress;
  const double modulus = material.young / (plane_stress ? 1 : 1 - material.poisson * material.poisson);
  return std::sqrt(modulus / material.density);
}

double p_wave_speed(const Material& material) {
  return std::sqrt(elasticity_matrix(material)(0, 0) / material.density);
}

double s_wave_speed(const Material& material) {
  return std::sqrt(elasticity_matrix(material)(2, 2) / material.density);
}

}  // namespace dda
