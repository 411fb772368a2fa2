#include "engine/scene/rock_values.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

namespace dda {

double read_poisson(const Field& field, PlaneState plane) {
  const double poisson = field.quantity(Dimension::dimensionless);
  const bool strain = plane == PlaneState::strain;
  if (poisson <= -1 || poisson > 0.5 || (strain && poisson == 0.5)) {
    field.fail(strain ? "a number above -1 and below 0.5 in plane strain" : "a number above -1 and at most 0.5");
  }
  return poisson;
}

namespace {

// Whoever writes a number may have meant degrees.
[[noreturn]] void fail_as_angle(const Field& field, const std::string& expected, const char* example) {
  if (field.is_text()) field.fail(expected);
  field.fail(fmt::format("{}; without a unit it is in radians, for degrees write \"{}\"", expected, example));
}

void require_acute(const Field& field, double angle, const char* example) {
  if (!(angle < std::numbers::pi / 2)) fail_as_angle(field, "an angle below 90 deg", example);
}

}  // namespace

double read_friction_angle(const Field& field) {
  const double angle = field.not_negative(Dimension::angle);
  require_acute(field, angle, "35 deg");
  return angle;
}

double read_corner(const Field& field) {
  const double angle = field.positive(Dimension::angle);
  require_acute(field, angle, "5 deg");
  return angle;
}

double read_direction(const Field& field) {
  const double angle = field.quantity(Dimension::angle);
  if (std::abs(angle) > 2 * std::numbers::pi)
    fail_as_angle(field, "an angle of at most a full turn, 360 deg", "60 deg");
  return angle;
}

double read_angle_of_turn(const Field& field) {
  const double angle = field.quantity(Dimension::angle);
  if (!field.is_text() && std::abs(angle) > 2 * std::numbers::pi)
    fail_as_angle(field, "an angle of at most a full turn, or one with its unit", "60 deg");
  return angle;
}

}  // namespace dda
