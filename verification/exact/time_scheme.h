// One-step time integration schemes as exact objects: parameters, z-domain operators, amplification of an oscillator.
//
// A step solves, with x_(n+1-a) = (1 - a) x_(n+1) + a x_n,
//   M a_(n+1-am) + C v_(n+1-af) + K u_(n+1-af) = F_(n+1-af)
//   u_(n+1) = u_n + dt k v_n + dt^2 ((1/2 - beta) a_n + beta a_(n+1))
//   v_(n+1) = k v_n + dt ((1 - gamma) a_n + gamma a_(n+1)),
// where k is `carried_velocity` (the dynamic parameter k01 of DDA; 1: fully dynamic, 0: static).
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

namespace exact {

// Inverse transforms magnify round-off by the radius of their contour, so they are taken in extended precision.
using Real = long double;
using Complex = std::complex<Real>;
[[nodiscard]] constexpr Real widen(double value) { return static_cast<Real>(value); }

struct TimeScheme {
  double beta = 0.25;
  double gamma = 0.5;
  double alpha_m = 0.0;
  double alpha_f = 0.0;
  double carried_velocity = 1.0;
};

// Zelig (2015) Eq. 5: beta = 1/2, gamma = 1; equilibrium at the end of the step, acceleration constant over it.
[[nodiscard]] TimeScheme thesis_scheme();

// beta = 1/4, gamma = 1/2: second order, no numerical damping.
[[nodiscard]] TimeScheme trapezoidal();

// Hilber, Hughes & Taylor (1977): alpha_f = alpha in [0, 1/3], beta = (1 + alpha)^2/4, gamma = 1/2 + alpha.
[[nodiscard]] TimeScheme hht(double alpha);

// Chung & Hulbert (1993): rho_inf in [0, 1] is the spectral radius at infinite frequency.
[[nodiscard]] TimeScheme generalized_alpha(double rho_inf);

// Relative error of the period (-): an undamped oscillation of frequency omega gets the frequency omega_num with
// omega_num^2 = omega^2 (1 - period_error (omega dt)^2) + higher orders (real parts). Needs carried_velocity = 1. For
// second-order schemes, gamma = 1/2 + alpha_f - alpha_m, it is beta - 1/12 - alpha_f (alpha_f - alpha_m).
[[nodiscard]] double period_error(const TimeScheme& scheme);

// The scheme seen by z-transforms X(z) = sum x_n z^-n of a motion that starts with u = v = 0 and M a_0 = F_0:
//   (inertia M + damping C + K) U(z) = F(z) + initial_load F_0.
// `inertia` (1/s^2) and `damping` (1/s) stand for s^2 and s of the Laplace transform; -inertia at z = exp(i omega dt)
// is the squared frequency omega~^2 that the scheme gives to the space operator. `initial_load` (-) assumes C a_0 = 0:
// either F_0 = 0 or no dashpot acts where the first load does.
struct SchemeOperators {
  Complex inertia;
  Complex damping;
  Complex initial_load;
};
[[nodiscard]] SchemeOperators scheme_operators(const TimeScheme& scheme, double dt, Complex z);

// The step as a matrix on (u, dt v, dt^2 a) of a free oscillator with theta = omega dt and damping ratio xi (-).
[[nodiscard]] Eigen::Matrix3d amplification_matrix(const TimeScheme& scheme, double theta, double xi = 0.0);

// Largest modulus of its eigenvalues: the amplitude factor of one step.
[[nodiscard]] double spectral_radius(const TimeScheme& scheme, double theta, double xi = 0.0);

// Exact discrete displacement (m) after 0..steps steps of an undamped oscillator released at u = u0, v = 0.
[[nodiscard]] std::vector<double> free_oscillation(const TimeScheme& scheme, double omega, double dt, int steps,
                                                   double u0 = 1.0);

}  // namespace exact
