// Plane waves at normal incidence on joints between half-spaces of one impedance Z = rho c (Pa s/m). Time dependence
// exp(i omega t); amplitudes of stress over that of the incident wave, P or S alike.
#pragma once

#include <complex>
#include <span>

namespace exact {

// Displacement discontinuity with stress = stiffness (Pa/m) * jump: T = 1/(1 + i omega Z/(2 stiffness)), R = 1 - T for
// the stress (Pyrak-Nolte, Myer & Cook 1990, https://doi.org/10.1029/JB095iB06p08617).
[[nodiscard]] std::complex<double> linear_joint_transmission(double omega, double impedance, double stiffness);

// `joints` such joints at equal distances `spacing` (m) in rock of wave speed `speed` (m/s), between the planes of the
// first and the last joint: product of their transfer matrices; the same as the recursion of Cai & Zhao 2000,
// https://doi.org/10.1016/S1365-1609(00)00013-7. Includes the delay of the way between the first and last joint.
[[nodiscard]] std::complex<double> joints_transmission(double omega, double impedance, double stiffness, int joints,
                                                       double spacing, double speed);

// A joint that sticks below the shear stress `strength` and slides at it, under a harmonic S wave of amplitude 1
// (Miller 1978): transmitted stress is the incident one clipped at the strength. Root of the energy transmitted,
// reflected and absorbed by sliding over the incident energy: T^2 + R^2 + A^2 = 1.
struct SlipJointEnergies {
  double transmitted = 0, reflected = 0, absorbed = 0;
};
[[nodiscard]] SlipJointEnergies slip_joint(double strength);

// integral of samples * exp(-i omega t) dt by the trapezoidal rule; the samples should vanish at both ends.
[[nodiscard]] std::complex<double> fourier(std::span<const double> samples, double dt, double omega);

}  // namespace exact
