// Small exact formulas of elastodynamics, statics of block stacks and rigid motion. SI units; E Young's modulus (Pa),
// nu Poisson's ratio (-), rho density (kg/m3).
#pragma once

#include <cmath>

namespace exact {

// --- Wave speeds (m/s) ---
[[nodiscard]] inline double bar_speed(double young, double density) { return std::sqrt(young / density); }
[[nodiscard]] inline double p_speed_plane_stress(double young, double poisson, double density) {
  return std::sqrt(young / ((1 - poisson * poisson) * density));
}
[[nodiscard]] inline double p_speed_plane_strain(double young, double poisson, double density) {
  return std::sqrt(young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson) * density));
}
// sqrt(G/rho), G = E/(2 (1 + nu)): the same in plane stress and plane strain.
[[nodiscard]] inline double s_speed(double young, double poisson, double density) {
  return std::sqrt(young / (2 * (1 + poisson) * density));
}

// --- Ends of a bar ---
// Stress reflected over stress arriving, with sign, at an end of impedance ratio a = Z/(rho c A): 0 absorbs, a = 0
// (free) gives -1, a -> infinity (fixed) gives +1. The velocity reflects with the opposite sign.
[[nodiscard]] inline double stress_reflection(double impedance_ratio) {
  return (impedance_ratio - 1) / (impedance_ratio + 1);
}
[[nodiscard]] inline double reflected_energy_fraction(double impedance_ratio) {
  return std::pow(stress_reflection(impedance_ratio), 2);
}
// Energy (J) that n whole cycles of a force P sin(2 pi f t) put into a bar: n P^2/(2 f rho c A), half kinetic, half
// strain.
[[nodiscard]] inline double sine_pulse_energy(double force, double frequency, double impedance, double cycles = 1) {
  return cycles * force * force / (2 * frequency * impedance);
}

// --- Uniaxial compression: lateral over axial strain, with the sign taken out ---
[[nodiscard]] inline double lateral_ratio_plane_stress(double poisson) { return poisson; }
[[nodiscard]] inline double lateral_ratio_plane_strain(double poisson) { return poisson / (1 - poisson); }

// --- Stacks of blocks of length L (m) and cross section A (m2) joined by interfaces of normal stiffness k (N/m) ---
// With vertex-edge springs of stiffness g0 (N/m) each, k = n g0 for the n springs of one interface; n = 2 for two
// corners. An interface adds A/k of compliance to L/E: apparent modulus (Pa) with one interface per block (an endless
// stack, or one that stands on a sprung base).
[[nodiscard]] inline double stack_modulus(double young, double length, double area, double interface_stiffness) {
  return young / (1 + young * area / (interface_stiffness * length));
}
// `blocks` blocks with the blocks - 1 interfaces between them.
[[nodiscard]] inline double stack_modulus(double young, double length, double area, double interface_stiffness,
                                          int blocks) {
  return young / (1 + young * area / (interface_stiffness * length) * (blocks - 1) / blocks);
}

// --- Column of height H (m) under its own weight, on a base ---
// Compression (Pa) at height y: rho g (H - y). A constant-stress block carries the value of its centroid exactly.
[[nodiscard]] inline double self_weight_pressure(double density, double gravity, double height, double y) {
  return density * gravity * (height - y);
}
[[nodiscard]] inline double self_weight_shortening(double young, double density, double gravity, double height) {
  return density * gravity * height * height / (2 * young);
}
// Descent (m) of the top of a column of equal constant-stress blocks of length L: the continuum's shortening, exactly,
// plus sum (blocks - i) W/k over the interfaces i = 0 (the base, if it is a spring too) .. blocks - 1; W = rho g A L.
[[nodiscard]] inline double block_column_shortening(double young, double density, double gravity, double length,
                                                    double area, int blocks, double interface_stiffness,
                                                    bool sprung_base) {
  const double weight = density * gravity * area * length;
  const double carried = sprung_base ? blocks * (blocks + 1.0) / 2 : blocks * (blocks - 1.0) / 2;
  return self_weight_shortening(young, density, gravity, blocks * length) + carried * weight / interface_stiffness;
}

// --- Rigid motion ---
// s = g t^2/2 from rest; exact for every Newmark scheme that starts with a = g, since a stays constant.
[[nodiscard]] inline double free_fall(double gravity, double t) { return gravity * t * t / 2; }

// Fall with the velocity carried to the next step multiplied by k < 1. All three are limits after many steps:
struct TerminalVelocity {
  double carried;  // at the start of a step: k g dt/(1 - k)
  double end;      // at the end of a step: g dt/(1 - k)
  double mean;     // displacement per step over dt, any Newmark scheme: g dt (1 + k)/(2 (1 - k))
};
[[nodiscard]] inline TerminalVelocity terminal_velocity(double gravity, double dt, double carried_velocity) {
  const double end = gravity * dt / (1 - carried_velocity);
  return {carried_velocity * end, end, (1 + carried_velocity) * end / 2};
}
// Velocity at the end of step n >= 1: g dt (1 - k^n)/(1 - k).
[[nodiscard]] inline double velocity_after_steps(double gravity, double dt, double carried_velocity, int steps) {
  return gravity * dt * (1 - std::pow(carried_velocity, steps)) / (1 - carried_velocity);
}

// --- Contact oscillator (mass on a spring, omega = sqrt(k/m)) under thesis Eq. 5, theta = omega dt < 4 ---
// Amplitude factor and phase (rad) of one step: exact eigenvalue of the scheme. For small theta: exp(-theta^2/4),
// theta.
[[nodiscard]] inline double thesis_step_factor(double theta) { return 1 / std::sqrt(1 + theta * theta / 2); }
[[nodiscard]] inline double thesis_step_phase(double theta) {
  return std::acos((1 - theta * theta / 4) * thesis_step_factor(theta));
}
// exp(-omega^2 dt t/4): the limit of thesis_step_factor^(t/dt); its exponent is short by t/dt theta^4/16.
[[nodiscard]] inline double thesis_decay(double omega, double dt, double t) {
  return std::exp(-omega * omega * dt * t / 4);
}

}  // namespace exact
