// A symmetric triangular prism in a roof, between two planes that stand at alpha to the vertical and meet above it:
// it falls when its weight exceeds what friction f on the two planes holds under a horizontal thrust H (N per m of
// thickness) through the roof (Brady and Brown 1985, chapter 9). The planes have no cohesion and f > alpha.
#pragma once

#include <cmath>

namespace exact {

struct RoofPrism {
  double alpha = 0;     // rad, half of the angle at the apex
  double friction = 0;  // rad
};

// H is kept, as between abutments that follow: each plane carries N = H cos f/cos(f - alpha), S = N tan f at the limit.
[[nodiscard]] inline double held_weight_at_constant_thrust(const RoofPrism& prism, double thrust) {
  return 2 * thrust * std::tan(prism.friction - prism.alpha);
}

// H is the thrust before the prism's weight comes on, and the abutments do not move. Sinking by u_y then takes normal
// force k_n u_y sin(alpha) off each plane and adds shear force k_s u_y cos(alpha) to N = H cos(alpha),
// S = H sin(alpha), until S = N tan f. k_n, k_s: stiffness of one plane.
[[nodiscard]] inline double held_weight_between_fixed_abutments(const RoofPrism& prism, double thrust,
                                                                double shear_over_normal_stiffness) {
  const double s = std::sin(prism.alpha);
  const double c = std::cos(prism.alpha);
  const double k = shear_over_normal_stiffness;
  const double relaxed = k * c * std::cos(prism.friction) + s * std::sin(prism.friction);
  return 2 * thrust * (k * c * c + s * s) * std::sin(prism.friction - prism.alpha) / relaxed;
}

}  // namespace exact
