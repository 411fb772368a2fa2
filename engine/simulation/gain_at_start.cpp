#include "engine/simulation/gain_at_start.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "engine/simulation/block_system.h"

namespace dda {
namespace {

double gain_after(double steps, const BlockSystem& system) {
  const Integrator& integrator = system.stage_in_force().integrator;
  if (integrator.is_static || integrator.is_explicit()) return 0;
  const double kappa = 1 - integrator.gamma / (2 * integrator.beta);
  const double rho = integrator.alpha_f / (1 - integrator.alpha_f);
  const double left = kappa * steps * std::pow(rho, steps - 1);
  return left * left * system.audit.of_start.free_step;
}

}  // namespace

double energy_of_a_free_step(const BlockSystem& system) {
  double energy = 0;
  for (std::size_t i = 0; i < system.state.acceleration.size(); ++i) {
    const Vec6 velocity = system.coefficients.dt * system.state.acceleration[i];
    energy += velocity.dot(momentum(system.terms.inertia[i], velocity)) / 2;
  }
  return energy;
}

double gain_of_first_step(const BlockSystem& system) { return gain_after(1, system); }

double gain_at_start(const BlockSystem& system) {
  if (system.clock.step == 0) return 0;
  const std::int64_t first =
      system.stage_in_force().chosen.dt.first_steps.number();  // accelerations begin anew after them
  return gain_after(static_cast<double>(system.clock.step > first ? system.clock.step - first : system.clock.step),
                    system);
}

}  // namespace dda
