#include "engine/scene/rock_values.h"

#include <numbers>

namespace dda {

double read_poisson(const Field& field, PlaneState plane) {
  const double poisson = field.quantity(Dimension::dimensionless);
  const bool strain = plane == PlaneState::strain;
  if (poisson <= -1 || poisson > 0.5 || (strain && poisson == 0.5)) {
    field.fail(strain ? "a number above -1 and below 0.5 in plane strain" : "a number above -1 and at most 0.5");
  }
  return poisson;
}

double read_friction_angle(const Field& field) {
  const double angle = field.not_negative(Dimension::angle);
  if (angle < std::numbers::pi / 2) return angle;
  field.fail(field.is_text() ? "an angle below 90 deg"
                             : "an angle below 90 deg; without a unit it is in radians, for degrees write \"35 deg\"");
}

}  // namespace dda
