// Dispersion of the block chain in one dimension, as scalar closed forms: the shortest check of an engine's wave speed.
#pragma once

#include "verification/exact/chain_modes.h"

namespace exact {

// Blocks without lateral coupling: Poisson ratio 0, or corner springs without shear and lateral inertia neglected (then
// `young` is that of the lateral condition). For anything else use chain_wave().
struct ScalarChain {
  double young = 0;           // Pa
  double density = 0;         // kg/m3
  double length = 1;          // m, of one block
  double area = 1;            // m2, of the cross section
  double normal = 0;          // N/m, stiffness k of one interface
  double inertia_factor = 1;  // as in BlockChain
  bool consistent = false;
};

// X = sin^2(kappa/2) of the wave with the longest wavelength, kappa the phase per block. With Kb = E A/L,
// w = omega~^2 m/Kb (omega~^2 = -inertia operator), q = k/Kb, a = inertia_factor/12, S^2 = 4 X, C^2 = 1 - X:
//   corner springs   1/q = S^2/w - C^2/(1 - a w)
//   consistent edge  w (1 - a w) + w (q - 2) C^2 - q S^2 (1 - a w) + S^2 C^2 = 0
[[nodiscard]] Complex corner_spring_sin2(Complex w, Real q, Real a);
[[nodiscard]] Complex consistent_edge_sin2(Complex w, Real q, Real a);

// To leading order in Omega = omega L/c and theta = omega dt, with eta_s = E A/(k L) and f the inertia factor:
//   corner springs   speed/c = 1 - eta_s/2 + (2 - f) Omega^2/24 + time,  consistent edge: the same without eta_s,
// time = theta^2/96 for thesis Eq. 5 and -theta^2/12 for the trapezoidal rule.
[[nodiscard]] ChainWave phase_speed(const ScalarChain& chain, const TimeScheme& scheme, double dt, double omega);

}  // namespace exact
