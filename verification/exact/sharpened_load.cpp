#include "verification/exact/sharpened_load.h"

#include <cstddef>

namespace exact {

double load_sharpening(const BlockChain& chain, double dt) {
  const double courant2 = bar_modulus(chain.elasticity) / chain.density * dt * dt / (chain.length * chain.length);
  return chain.interface.inertia_reduction / courant2;
}

std::vector<double> sharpened(const std::vector<double>& load, double share) {
  std::vector<double> result = load;
  if (share == 0) return result;
  for (std::size_t i = 1; i < load.size(); ++i) {
    const double after = load[i + 1 < load.size() ? i + 1 : i];
    result[i] -= share * (load[i - 1] - 2 * load[i] + after);
  }
  return result;
}

}  // namespace exact
