#include "engine/simulation/step_coefficients.h"

namespace dda {
namespace {

// Sets the means over the step alone, as its motion and the new acceleration do not follow from one another.
StepCoefficients central_difference_coefficients(double dt) {
  StepCoefficients c;
  c.dt = dt;
  c.load_new = c.load_old = 0.5;
  c.v_v = 1;
  c.v_a0 = c.v_a1 = dt / 2;
  c.weight_new_a = 0.5;
  c.acts_at = 0.5;
  return c;
}

}  // namespace

StepCoefficients step_coefficients(const Integrator& integrator, double dt) {
  if (integrator.is_explicit()) return central_difference_coefficients(dt);
  const double beta = integrator.beta;
  const double gamma = integrator.gamma;
  const double new_m = 1 - integrator.alpha_m;
  const double new_f = 1 - integrator.alpha_f;
  const double old_a = 1 / (2 * beta) - 1;
  StepCoefficients c;
  c.dt = dt;
  c.mass = new_m / (beta * dt * dt);
  c.mass_v = new_m / (beta * dt);
  c.mass_a = new_m * old_a - integrator.alpha_m;
  c.damping = new_f * gamma / (beta * dt);
  c.damping_v = new_f * (1 - gamma / beta) + integrator.alpha_f;
  c.damping_a = new_f * dt * (1 - gamma / (2 * beta));
  c.stiffness = new_f;
  c.load_new = new_f;
  c.load_old = integrator.alpha_f;
  c.a_d = 1 / (beta * dt * dt);
  c.a_v = -1 / (beta * dt);
  c.a_a = -old_a;
  c.v_v = 1;
  c.v_a0 = dt * (1 - gamma);
  c.v_a1 = dt * gamma;
  c.weight_new_a = new_m;
  // v1 - v0 = dt ((1 - gamma) a0 + gamma a1) is the integral of the acceleration to second order if a0 and a1 belong to
  // moments 1/2 - gamma of a step after its start and its end. The balance has a0 + new_m (a1 - a0).
  c.acts_at = 0.5 - gamma + new_m;
  return c;
}

}  // namespace dda
