// Lines of thrust in a semicircular arch of equal voussoirs with radial joints, under its own weight, on abutments that
// do not move. Joints carry no tension and do not slide. Mean radius 1, weight of a voussoir 1; voussoirs have straight
// edges, as the engine's blocks do.
//
// The forces on the part between the crown and joint j are the thrust H at a height h/H above the springings, and the
// weights. Their moment about the joint's intrados must not be positive and that about its extrados not negative:
//   H y_i + S_i <= h <= H y_o + S_o,  S = sum of weight times (x - x_weight),
// so an arch stands when max over H of (min over joints of the right - max over joints of the left) is not negative: a
// concave function of H. For many voussoirs the least thickness is 0.1075 of the radius (Milankovitch 1907).
#pragma once

namespace exact {

struct Arch {
  int voussoirs = 0;
  double thickness = 0;  // over the mean radius
};

// The largest gap, over all thrusts, between the bounds of h: negative when no line of thrust fits.
[[nodiscard]] double thrust_margin(const Arch& arch);

// The least thickness over mean radius with which the arch stands.
[[nodiscard]] double least_thickness(int voussoirs);

// Tangent of the largest angle between the force on a joint and the joint's normal, for the thrust of thrust_margin:
// the friction that keeps joints from sliding.
[[nodiscard]] double needed_friction(const Arch& arch);

}  // namespace exact
