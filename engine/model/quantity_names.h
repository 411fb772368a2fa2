// Names and units of what can be measured, as scenes and CSV headers write them.
#pragma once

#include <array>
#include <string_view>

#include "engine/model/model.h"

namespace dda {

inline constexpr std::array all_quantities = {
    Quantity::stress_xx,      Quantity::stress_yy,  Quantity::stress_xy,       Quantity::displacement_x,
    Quantity::displacement_y, Quantity::velocity_x, Quantity::velocity_y,      Quantity::acceleration_x,
    Quantity::acceleration_y, Quantity::rotation,   Quantity::traction_normal, Quantity::traction_shear,
    Quantity::bolt_force,     Quantity::bolt_shear, Quantity::bolt_elongation,
};

constexpr std::string_view to_string(Quantity quantity) {
  switch (quantity) {
    case Quantity::stress_xx: return "stress_xx";
    case Quantity::stress_yy: return "stress_yy";
    case Quantity::stress_xy: return "stress_xy";
    case Quantity::displacement_x: return "displacement_x";
    case Quantity::displacement_y: return "displacement_y";
    case Quantity::velocity_x: return "velocity_x";
    case Quantity::velocity_y: return "velocity_y";
    case Quantity::acceleration_x: return "acceleration_x";
    case Quantity::acceleration_y: return "acceleration_y";
    case Quantity::rotation: return "rotation";
    case Quantity::traction_normal: return "traction_normal";
    case Quantity::traction_shear: return "traction_shear";
    case Quantity::bolt_force: return "bolt_force";
    case Quantity::bolt_shear: return "bolt_shear";
    case Quantity::bolt_elongation: return "bolt_elongation";
  }
  return "unknown";
}

// The SI unit.
constexpr std::string_view unit_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::stress_xx:
    case Quantity::stress_yy:
    case Quantity::stress_xy:
    case Quantity::traction_normal:
    case Quantity::traction_shear: return "Pa";
    case Quantity::displacement_x:
    case Quantity::displacement_y:
    case Quantity::bolt_elongation: return "m";
    case Quantity::bolt_force:
    case Quantity::bolt_shear: return "N";
    case Quantity::velocity_x:
    case Quantity::velocity_y: return "m/s";
    case Quantity::acceleration_x:
    case Quantity::acceleration_y: return "m/s2";
    case Quantity::rotation: return "rad";
  }
  return "";
}

}  // namespace dda
