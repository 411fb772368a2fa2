// A cylindrical cavity in an endless elastic body with a pressure on its wall that changes in time: axisymmetric, plane
// strain or plane stress by its moduli. SI units; stress positive in tension.
#pragma once

#include <functional>
#include <vector>

namespace exact {

struct Cavity {
  double radius = 0;     // m
  double p_modulus = 0;  // Pa, rho c_P^2; that of plane stress for plane stress
  double shear = 0;      // Pa, rho c_S^2
  double density = 0;    // kg/m3
};

// What happens at one radius, sampled at 0, interval, 2 interval, ...
struct RadialHistory {
  std::vector<double> radial_stress;  // Pa
  std::vector<double> hoop_stress;    // Pa
  std::vector<double> velocity;       // m/s, outwards
};

struct CavityMotion {
  double interval = 0;                   // s
  std::vector<RadialHistory> histories;  // one for each radius asked for
};

// From rest, `pressure` (Pa, of the time in s, from 0 on at the start) on the wall, for `duration` s, at `radii` (m,
// from the wall on). Finite differences of second order: linear displacements in rings of equal thickness,
// `rings_per_radius` in the radius of the cavity, with lumped masses and central differences in time at 0.95 of the
// time a P wave takes through a ring. The body ends so far out that nothing comes back in time. Throws
// std::invalid_argument for a radius inside the cavity.
[[nodiscard]] CavityMotion pressurised_cavity(const Cavity& cavity, const std::function<double(double)>& pressure,
                                              const std::vector<double>& radii, double duration, int rings_per_radius);

struct RadialStress {
  double radial = 0;  // Pa
  double hoop = 0;    // Pa
};

// Lame (1852): a ring a < r < b with the pressures inside and outside held. b may be infinite.
[[nodiscard]] RadialStress lame_ring(double inner_radius, double outer_radius, double inner_pressure,
                                     double outer_pressure, double radius);

// The circular cavity (radius, m) whose far static stresses, -p a^2/r^2, are those of a regular octagon of the same
// area as a circle of radius `equal_area` under the same pressure: a^2 = R^2 (1 + (n - 1) m^2), n = 8, with the
// conformal map R (w + m w^(1-n)) from outside the unit circle, m = 2/(n (n - 1)), by Muskhelishvili's boundary
// equation; R is the octagon's conformal radius, 1.24581 of its edge (Polya & Szego 1951).
[[nodiscard]] double octagon_source_radius(double equal_area);

}  // namespace exact
