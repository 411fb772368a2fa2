#include "verification/cases/every_integrator.h"

#include <fmt/format.h>

namespace verify {

std::vector<dda::Integrator> every_integrator() {
  std::vector<dda::Integrator> all{dda::thesis_integrator(), dda::trapezoidal_integrator(),
                                   dda::energy_conserving_integrator()};
  for (const double alpha : {0.0, 0.1, 0.3}) {
    all.push_back(dda::hht_integrator(alpha));
    all.back().name = fmt::format("hht {}", alpha);
  }
  for (const double rho_inf : {0.0, 0.5, 0.8, 1.0}) {
    all.push_back(dda::generalized_alpha_integrator(rho_inf));
    all.back().name = fmt::format("generalized_alpha {}", rho_inf);
  }
  return all;
}

}  // namespace verify
