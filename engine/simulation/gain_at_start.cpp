#include "engine/simulation/gain_at_start.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "engine/simulation/block_system.h"

namespace dda {

double energy_of_a_free_step(const BlockSystem& system) {
  double energy = 0;
  for (std::size_t i = 0; i < system.state.acceleration.size(); ++i) {
    const Vec6 velocity = system.coefficients.dt * system.state.acceleration[i];
    energy += velocity.dot(momentum(system.terms.inertia[i], velocity)) / 2;
  }
  return energy;
}

double gain_at_start(const BlockSystem& system) {
  const Integrator& integrator = system.stage_in_force().integrator;
  if (system.clock.step == 0 || integrator.is_static || integrator.is_explicit()) return 0;
  const std::int64_t first =
      system.stage_in_force().chosen.dt.first_steps.number();  // accelerations begin anew after them
  const auto steps = static_cast<double>(system.clock.step > first ? system.clock.step - first : system.clock.step);
  const double kappa = 1 - integrator.gamma / (2 * integrator.beta);
  const double rho = integrator.alpha_f / (1 - integrator.alpha_f);
  const double left = kappa * steps * std::pow(rho, steps - 1);
  return left * left * system.audit.energy_of_free_step();
}

}  // namespace dda
