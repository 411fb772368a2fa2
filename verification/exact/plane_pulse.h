// A P and an S wave from a smooth source in an endless elastic plane.
//
// The force on the area is intensity g(t) (grad b + rot b), b = exp(-r^2/(2 s^2)), rot b = (db/dy, -db/dx), and
// g(t) = sin(w t) (1 - cos(w t)) for one period of w = 2 pi frequency. Its two parts feed one wave each (Helmholtz):
//   u = grad phi + rot chi,  rho phi'' = rho c_p^2 lap phi + intensity g b,  rho chi'' = rho c_s^2 lap chi + the same,
// solved by Hankel's transform (Achenbach 1973, sections 2.10 and 3.9): with h'' + (c k)^2 h = g from rest,
//   d(phi)/dr = -(intensity/rho) s^2 integral of exp(-k^2 s^2/2) h(k, t; c_p) J1(k r) k^2 over k from 0 on.
#pragma once

#include <vector>

namespace exact {

struct PlanePulse {
  double density = 0;    // kg/m3
  double p_speed = 0;    // m/s
  double s_speed = 0;    // m/s
  double radius = 0;     // m, s above
  double frequency = 0;  // Hz
  double intensity = 0;  // N/m2, times metres of b's derivative: a force on an area
};

// g above: zero, with its first two derivatives, where the pulse starts and ends.
[[nodiscard]] double pulse_history(double frequency, double t);

// Force on the area at (x, y), over g: N/m2.
struct SourceForce {
  double x = 0, y = 0;
};
[[nodiscard]] SourceForce source_force(const PlanePulse& pulse, double x, double y);

// Displacement (m) at a distance from the source, at t = 0, dt, 2 dt, ...
struct DisplacementHistory {
  std::vector<double> outward;    // of the P wave
  std::vector<double> clockwise;  // of the S wave
};

// `samples` of it at distance r > 0 (m). Quadrature error below 1e-8 of the peak while r and c_p t are below 60 s.
[[nodiscard]] DisplacementHistory displacement_history(const PlanePulse& pulse, double r, double dt, int samples);

}  // namespace exact
