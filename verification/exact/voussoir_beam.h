// A flat roof of voussoirs with upright joints between abutments that do not move: an arch of rise z over the span S,
// under its weight W alone. Moments about the springing give the thrust T = W S/(8 z); each abutment carries W/2 by
// friction, so it needs the coefficient (W/2)/T = 4 z/S. The force runs at most from edge to edge of the beam: z <= its
// thickness t, less what it sags. Beer and Meek (1982) let it run in the middle of compressed wedges n t high:
// z = t (1 - 2 n/3), n = 0.75.
// A roof without thrust has no friction, whatever its coefficient: it may fall as one.
#pragma once

namespace exact {

[[nodiscard]] inline double voussoir_thrust(double weight, double span, double rise) {
  return weight * span / (8 * rise);
}

[[nodiscard]] inline double voussoir_needed_friction(double span, double rise) { return 4 * rise / span; }

[[nodiscard]] inline double beer_meek_rise(double thickness, double share = 0.75) {
  return thickness * (1 - 2 * share / 3);
}

}  // namespace exact
