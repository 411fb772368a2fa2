#include "engine/advice/time_steps.h"

#include <algorithm>
#include <cmath>

namespace dda {

MaterialDamping damping_of(const Stage& stage) {
  MaterialDamping damping = stage.material_damping;
  damping.mass += stage.damping_rate;
  if (stage.velocity_factor != 1) damping.mass -= std::log(std::max(stage.velocity_factor, 1e-12)) / stage.dt;
  return damping;
}

Complex stepped_square(const Integrator& integrator, double dt, Complex s) {
  const double beta = integrator.beta;
  const double gamma = integrator.gamma;
  const Complex back = std::exp(-s * dt);  // 1/z: does not overflow
  const Complex newmark = beta + (0.5 + gamma - 2 * beta) * back + (0.5 - gamma + beta) * back * back;
  const Complex half_sine = 2.0 * std::sinh(s * dt / 2.0);  // its square is z - 2 + 1/z, without cancellation
  const Complex inertia_weight = (1 - integrator.alpha_m) + integrator.alpha_m * back;
  const Complex force_weight = (1 - integrator.alpha_f) + integrator.alpha_f * back;
  return half_sine * half_sine * back / (dt * dt * newmark) * inertia_weight / force_weight;
}

}  // namespace dda
