#include "verification/exact/dispersion.h"

#include <cmath>

namespace exact {

Complex corner_spring_sin2(Complex w, Real q, Real a) {
  const Complex block = Real{1} - a * w;
  return w * (block + q) / (q * (w + Real{4} * block));
}

// 4 X^2 + b X = c has its small root at 2 c/(b + sqrt(b^2 + 16 c)), the sign of the square root chosen against
// cancellation.
Complex consistent_edge_sin2(Complex w, Real q, Real a) {
  const Complex block = Real{1} - a * w;
  const Complex b = w * (q - 2) + Real{4} * (q * block - Real{1}), c = w * (block + q - Real{2});
  const Complex root = std::sqrt(b * b + Real{16} * c);
  return Real{2} * c / (std::real(std::conj(b) * root) >= 0 ? b + root : b - root);
}

ChainWave phase_speed(const ScalarChain& chain, const TimeScheme& scheme, double dt, double omega) {
  const Complex z = std::polar<Real>(1, widen(omega * dt));
  const Real block_stiffness = widen(chain.young) * widen(chain.area) / widen(chain.length);
  const Real mass = widen(chain.density) * widen(chain.area) * widen(chain.length);
  const Complex w = -scheme_operators(scheme, dt, z).inertia * mass / block_stiffness;
  const Real q = widen(chain.normal) / block_stiffness, a = widen(chain.inertia_factor) / 12;
  return chain_wave(chain.consistent ? consistent_edge_sin2(w, q, a) : corner_spring_sin2(w, q, a), omega,
                    chain.length);
}

}  // namespace exact
