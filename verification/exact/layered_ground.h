// A plane wave that rises vertically through one layer on a half-space, up to the free surface and back: P or S alike.
// Kramer 1996, Geotechnical earthquake engineering, section 7.2.1 gives the amplification for harmonic waves; this is
// the same as a sum over the ways through the layer.
#pragma once

#include <cmath>
#include <functional>

namespace exact {

struct LayeredGround {
  double impedance_below = 0, impedance_above = 0;  // density * speed, Pa s/m
  double time_below = 0;                            // s, from where the incident wave is given up to the layer
  double time_above = 0;                            // s, through the layer
};

// Velocity of the free surface at `time` under the rising wave `incident` (velocity where it is given, zero before
// t = 0): 2 T sum over n of R^n incident(t - t_below - (2 n + 1) t_above), T = 2 Z_b/(Z_b + Z_a) into the layer and
// R = (Z_a - Z_b)/(Z_a + Z_b) on what comes back down.
inline double surface_velocity(const LayeredGround& ground, const std::function<double(double)>& incident,
                               double time) {
  const double sum = ground.impedance_below + ground.impedance_above;
  double share = 2 * 2 * ground.impedance_below / sum;
  const double reflected = (ground.impedance_above - ground.impedance_below) / sum;
  double velocity = 0;
  for (double t = time - ground.time_below - ground.time_above; t > 0 && share != 0; t -= 2 * ground.time_above) {
    velocity += share * incident(t);
    share *= reflected;
  }
  return velocity;
}

}  // namespace exact
