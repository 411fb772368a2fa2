// Strength of a joint under Mohr-Coulomb. Stresses in Pa; normal stress positive in compression.
#pragma once

#include <cmath>

namespace exact {

// c + sigma tan f: shear stress at which a joint slips.
[[nodiscard]] inline double shear_strength(double cohesion, double friction_angle, double normal_stress) {
  return cohesion + normal_stress * std::tan(friction_angle);
}

// rho g H: tensile strength that a block of height H and uniform section just needs to hang by its top.
[[nodiscard]] inline double hanging_strength(double density, double gravity, double height) {
  return density * gravity * height;
}

}  // namespace exact
