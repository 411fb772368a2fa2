#include "verification/exact/block_chain.h"

#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace exact {

PlaneElasticity plane_stress(double young, double poisson) {
  const double e11 = young / (1 - poisson * poisson);
  return {e11, poisson * e11};
}

PlaneElasticity plane_strain(double young, double poisson) {
  const double scale = young / ((1 + poisson) * (1 - 2 * poisson));
  return {(1 - poisson) * scale, poisson * scale};
}

InterfaceLaw corner_springs(double normal_spring, double shear_spring) {
  return {2 * normal_spring, 2 * shear_spring, false};
}

InterfaceLaw consistent_edge(double mid, double tangential_half) { return {mid, tangential_half, true}; }

InterfaceLaw cubic_edge(double inertia_reduction) { return {.cubic = true, .inertia_reduction = inertia_reduction}; }

double bar_modulus(const PlaneElasticity& elasticity) {
  return elasticity.e11 - elasticity.e12 * elasticity.e12 / elasticity.e11;
}

double inertia_reduction(const BlockChain& chain, double period_error, double dt) {
  const double courant2 = bar_modulus(chain.elasticity) / chain.density * dt * dt / (chain.length * chain.length);
  return std::min(period_error * courant2, 0.1);
}

double jump_inertia_reduction(const InterfaceLaw& law) { return std::min(law.inertia_reduction, 0.05); }

double end_share(const BlockChain& chain, Face face) {
  const bool held = face == Face::right && (chain.end_stiffness > 0 || chain.end_impedance > 0);
  return chain.interface.cubic && chain.blocks > 1 && !held ? (10 - std::numbers::sqrt2) / 12 : 1;
}

double end_inertia_reduction(const BlockChain& chain, Face face) {
  const double share = end_share(chain, face);
  return share < 1 ? 6 * share * jump_inertia_reduction(chain.interface) : 0;
}

void check(const BlockChain& chain, const std::vector<ChainProbe>& probes) {
  const bool sound = chain.blocks >= 1 && chain.length > 0 && chain.height > 0 && chain.density > 0 &&
                     chain.elasticity.e11 > 0 && chain.inertia_factor > 0 && chain.lateral_inertia >= 0 &&
                     (chain.interface.cubic ? chain.interface.normal >= 0 : chain.interface.normal > 0) &&
                     chain.interface.tangential_half >= 0 && chain.end_stiffness >= 0 && chain.end_impedance >= 0;
  if (!sound) throw std::invalid_argument("the chain needs positive sizes, density and stiffnesses");
  if (chain.interface.cubic && chain.interface.consistent) {
    throw std::invalid_argument("an interface is either cubic or consistent");
  }
  const auto exists = [&](const ChainProbe& probe) {
    const bool between =
        probe.quantity == ChainQuantity::interface_force || probe.quantity == ChainQuantity::interface_stress;
    const int count = between ? chain.blocks - 1 : chain.blocks;
    return probe.index >= 0 && probe.index < count;
  };
  if (!std::ranges::all_of(probes, exists)) throw std::invalid_argument("a probe lies outside of the chain");
}

}  // namespace exact
