#include "engine/advice/time_steps.h"

#include <cmath>

#include "engine/terms/velocity_damping.h"

namespace dda {
namespace {

// e^x - 1 without cancellation.
Complex expm1(Complex x) {
  const Complex half = x / 2.0;
  return 2.0 * std::exp(half) * std::sinh(half);
}

}  // namespace

double kept_in_step(const Stage& stage) { return velocity_factor(stage.velocity_factor, stage.damping_rate, stage.dt); }

Complex stepped_square(const Integrator& integrator, double dt, Complex s, double kept) {
  const double beta = integrator.beta;
  const double gamma = integrator.gamma;
  const Complex back = std::exp(-s * dt);  // 1/z: does not overflow
  // Both are over z.
  const Complex lost = (1 - kept) * back;  // 1 - k/z is 1 - 1/z and this
  const Complex less = -expm1(-s * dt);
  const Complex newmark = kept * (gamma + (1 - gamma) * back) * back + (less + lost) * (beta + (0.5 - beta) * back);
  const Complex inertia_weight = (1 - integrator.alpha_m) + integrator.alpha_m * back;
  const Complex force_weight = (1 - integrator.alpha_f) + integrator.alpha_f * back;
  return less * (less + lost) / (dt * dt * newmark) * inertia_weight / force_weight;
}

}  // namespace dda
