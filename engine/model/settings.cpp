#include "engine/model/settings.h"

#include <cmath>
#include <numbers>

namespace dda {

Integrator thesis_integrator() { return {"thesis", 0.5, 1.0, 0, 0, false}; }

Integrator trapezoidal_integrator() { return {"trapezoidal", 0.25, 0.5, 0, 0, false}; }

Integrator hht_integrator(double alpha) { return {"hht", (1 + alpha) * (1 + alpha) / 4, 0.5 + alpha, 0, alpha, false}; }

Integrator generalized_alpha_integrator(double rho_inf) {
  const double alpha_m = (2 * rho_inf - 1) / (rho_inf + 1);
  const double alpha_f = rho_inf / (rho_inf + 1);
  const double shift = 1 - alpha_m + alpha_f;
  return {"generalized_alpha", shift * shift / 4, 0.5 - alpha_m + alpha_f, alpha_m, alpha_f, false};
}

Integrator energy_conserving_integrator() {
  Integrator midpoint = generalized_alpha_integrator(1);
  midpoint.name = "energy_conserving";
  midpoint.conserves_contact_energy = true;
  return midpoint;
}

Integrator central_difference_integrator() { return {"central_difference", 0, 0.5, 0, 0, false}; }

Integrator with_contacts(const Integrator& integrator) {
  const auto is_scheme_of = [&](const Integrator& other) {
    return integrator.beta == other.beta && integrator.gamma == other.gamma && integrator.alpha_m == other.alpha_m &&
           integrator.alpha_f == other.alpha_f;
  };
  Integrator conserving = energy_conserving_integrator();
  if (!is_scheme_of(trapezoidal_integrator()) && !is_scheme_of(conserving)) return integrator;
  conserving.name = integrator.name;
  return conserving;
}

Integrator static_integrator() { return {"static", 0.5, 1.0, 0, 0, true}; }

std::int64_t Stage::steps() const {
  const FirstSteps& first = chosen.dt.first_steps;
  return paces_itself() ? 0 : first.number() + std::llround((duration - first.duration()) / dt);
}

double Stage::dt_of(std::int64_t step) const {
  const FirstSteps& first = chosen.dt.first_steps;
  return step < first.number() ? first.dt_of(step) : dt;
}

double Stage::time_of(std::int64_t step) const {
  const FirstSteps& first = chosen.dt.first_steps;
  if (step < first.number()) return first.time_of(step);
  return first.duration() + static_cast<double>(step - first.number()) * dt;
}

double MaterialDamping::ratio_at(double frequency) const {
  const double omega = 2 * std::numbers::pi * frequency;
  return mass / (2 * omega) + stiffness * omega / 2;
}

}  // namespace dda
