// Mean stress of a free elastic body that spins steadily: SI units, tension positive.
#pragma once

#include <array>

namespace exact {

// Integral of the stress over a body without loads on its surface = integral of (body force) x (place), whatever its
// shape and elasticity (the virial theorem); the force is rho omega^2 (x, y). For a rectangle with sides a and b along
// x and y: sigma_x = rho omega^2 a^2/12, sigma_y = rho omega^2 b^2/12, no shear.
[[nodiscard]] inline std::array<double, 2> mean_centrifugal_stress(double density, double spin, double a, double b) {
  const double all = density * spin * spin / 12;
  return {all * a * a, all * b * b};
}

}  // namespace exact
