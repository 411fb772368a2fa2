#include "verification/exact/time_scheme.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cstddef>

namespace exact {

TimeScheme thesis_scheme() { return {.beta = 0.5, .gamma = 1.0}; }

TimeScheme trapezoidal() { return {.beta = 0.25, .gamma = 0.5}; }

TimeScheme hht(double alpha) {
  return {.beta = (1 + alpha) * (1 + alpha) / 4, .gamma = 0.5 + alpha, .alpha_m = 0.0, .alpha_f = alpha};
}

TimeScheme generalized_alpha(double rho_inf) {
  const double alpha_m = (2 * rho_inf - 1) / (rho_inf + 1);
  const double alpha_f = rho_inf / (rho_inf + 1);
  const double excess = alpha_f - alpha_m;
  return {.beta = (1 + excess) * (1 + excess) / 4, .gamma = 0.5 + excess, .alpha_m = alpha_m, .alpha_f = alpha_f};
}

// With z = exp(i theta), -inertia dt^2 = theta^2 (1 - theta^2/12) (1 + i d theta + A theta^2)/(1 + i g theta + B
// theta^2) up to higher orders; the real part of its square root is theta (1 + period_error theta^2/2).
double period_error(const TimeScheme& scheme) {
  const double d = scheme.alpha_f - scheme.alpha_m, g = scheme.gamma - 0.5;
  const double a = d * (0.5 - scheme.alpha_f), b = g / 2 - scheme.beta;
  return -1.0 / 12 + a - b + (d * d - g * g) / 2 - (d - g) * (d - g) / 4;
}

// With A, V, U the transforms of acceleration, velocity and displacement and a_0 the acceleration at the start, the two
// update rules give U = gain A - start a_0; the equation of motion then holds between U, F and F_0 = M a_0 alone.
SchemeOperators scheme_operators(const TimeScheme& scheme, double dt, Complex z) {
  const Real step = widen(dt), beta = widen(scheme.beta), gamma = widen(scheme.gamma);
  const Real alpha_m = widen(scheme.alpha_m), alpha_f = widen(scheme.alpha_f);
  const Real carried = widen(scheme.carried_velocity), half = 0.5L, one = 1;
  const Complex velocity_gain = step * (one - gamma + gamma * z) / (z - carried);
  const Complex gain = step * (carried * velocity_gain + step * (half - beta + beta * z)) / (z - one);
  const Complex start = z * step * step * (carried * gamma / (z - carried) + beta) / (z - one);
  const Complex filter_m = (one - alpha_m) * z + alpha_m;
  const Complex filter_f = (one - alpha_f) * z + alpha_f;
  return {filter_m / (filter_f * gain), velocity_gain / gain,
          ((alpha_f - alpha_m) * z - filter_m * start / gain) / filter_f};
}

Eigen::Matrix3d amplification_matrix(const TimeScheme& scheme, double theta, double xi) {
  const double k = scheme.carried_velocity, am = scheme.alpha_m, af = scheme.alpha_f;
  const double stiffness = theta * theta, damping = 2 * xi * theta;
  Eigen::Matrix3d next, now;
  next << 1, 0, -scheme.beta,  //
      0, 1, -scheme.gamma,     //
      (1 - af) * stiffness, (1 - af) * damping, 1 - am;
  now << 1, k, 0.5 - scheme.beta,  //
      0, k, 1 - scheme.gamma,      //
      -af * stiffness, -af * damping, -am;
  return next.partialPivLu().solve(now);
}

double spectral_radius(const TimeScheme& scheme, double theta, double xi) {
  return amplification_matrix(scheme, theta, xi).eigenvalues().cwiseAbs().maxCoeff();
}

std::vector<double> free_oscillation(const TimeScheme& scheme, double omega, double dt, int steps, double u0) {
  const double theta = omega * dt;
  const Eigen::Matrix3d step = amplification_matrix(scheme, theta);
  Eigen::Vector3d state(u0, 0, -theta * theta * u0);
  std::vector<double> history{u0};
  history.reserve(static_cast<std::size_t>(steps) + 1);
  for (int i = 0; i < steps; ++i) {
    state = step * state;
    history.push_back(state[0]);
  }
  return history;
}

}  // namespace exact
