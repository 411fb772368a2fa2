// Plane waves that meet a viscous edge (Lysmer & Kuhlemeyer 1969) of an elastic half space at an angle.
//
// The half space is x < 0, its edge x = 0 carries the traction -a rho c_p v_x across and -b rho c_s v_y along. All
// waves go as exp(i omega t - i omega (s_x x + p y)) with one slowness p along the edge (Snell). With the slowness
// vector s and the polarization d of each wave, amplitude A, the two conditions on the edge are sums over the incident
// and the two reflected waves:
//   sum A [lambda s.d + 2 mu s_x d_x - a rho c_p d_x] = 0,   sum A [mu (s_x d_y + s_y d_x) - b rho c_s d_y] = 0.
// Polarizations: P along its direction; S that direction turned counter-clockwise by 90 degrees. A wave beyond its
// critical angle decays into the half space and carries no energy away from the edge.
#pragma once

#include <complex>

namespace exact {

enum class PlaneWave { p, s };

struct ViscousEdge {
  double p_speed = 0;  // m/s, of the plane state
  double s_speed = 0;  // m/s
  double across = 1;   // a: impedance over rho c_p
  double along = 1;    // b: impedance over rho c_s
};

struct Reflection {
  std::complex<double> p, s;  // displacement amplitudes over that of the incident wave
  double p_energy = 0;        // shares of the energy that arrives at the edge
  double s_energy = 0;
  double absorbed = 0;  // what the dashpots take, from their power: not 1 minus the others
};

// `angle` (rad) between the incident wave's direction and the normal, 0 <= angle < pi/2.
[[nodiscard]] Reflection reflect(const ViscousEdge& edge, PlaneWave incident, double angle);

}  // namespace exact
