// A cantilever of rectangular section and unit thickness in plane stress: SI units, x from the clamped end to L, y from
// the axis, load P downwards at x = L.
#pragma once

namespace exact {

struct Cantilever {
  double length = 0;   // m
  double height = 0;   // m
  double young = 0;    // Pa
  double poisson = 0;  // -
  double density = 0;  // kg/m3

  [[nodiscard]] double second_moment() const { return height * height * height / 12; }  // m4 per m of thickness
  [[nodiscard]] double shear_modulus() const { return young / (2 * (1 + poisson)); }
};

// P L^3/(3 E I): Euler and Bernoulli.
[[nodiscard]] double bending_deflection(const Cantilever& beam, double load);

// The same with the shear of Timoshenko's beam, P L/(kappa G A), kappa = 5/6. It is also what two-dimensional
// elasticity gives, exactly, for the deflection that does work: (work of the tractions at both ends)/P for the state
// below, since twice its strain energy is the integral of sigma^2/E + tau^2/G.
[[nodiscard]] double deflection_with_shear(const Cantilever& beam, double load);

// Two-dimensional state of stress (Timoshenko and Goodier 1951, art. 20): in equilibrium, compatible, and free of
// traction at y = +-h/2. Pa, tension positive.
[[nodiscard]] double fibre_stress(const Cantilever& beam, double load, double x, double y);  // P (L - x) y/I
[[nodiscard]] double shear_stress(const Cantilever& beam, double load, double y);            // -P/(2 I) (h^2/4 - y^2)
// Mean of shear_stress between two heights.
[[nodiscard]] double mean_shear_stress(const Cantilever& beam, double load, double lower, double upper);

// Lowest frequency (Hz) of Euler and Bernoulli's beam, 1.875104^2/(2 pi) sqrt(E I/(rho A L^4)), and its mode, of unit
// order: deflection and slope at x.
[[nodiscard]] double bending_frequency(const Cantilever& beam);
[[nodiscard]] double mode_deflection(const Cantilever& beam, double x);
[[nodiscard]] double mode_slope(const Cantilever& beam, double x);

// Lowest frequency (Hz) of Timoshenko's beam (shear and rotary inertia), kappa = 5 (1 + nu)/(6 + 5 nu), which agrees
// best with two-dimensional elasticity in plane stress (Timoshenko 1922). A root of the determinant of the end
// conditions, states along the beam by the exponential of its 4 x 4 system.
[[nodiscard]] double timoshenko_frequency(const Cantilever& beam);

}  // namespace exact
