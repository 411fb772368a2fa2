// Waves u_j ~ lambda^j of the infinite homogeneous block chain, for a given value of s^2 (the inertia operator).
#pragma once

#include <vector>

#include "verification/exact/block_chain.h"
#include "verification/exact/interface_forms.h"
#include "verification/exact/time_scheme.h"

namespace exact {

using ComplexVector3 = Eigen::Matrix<Complex, 3, 1>;

// One wave that decays to the right (|lambda| <= 1); its mirror image decays to the left. Where a wave neither decays
// nor grows, |lambda| = 1, it is left open which of the two this is. Amplitudes of block 0 and of the interface between
// blocks 0 and 1, in the units of the chain scaled by block length and e11 (see ScaledChain).
struct ChainMode {
  Complex sin2;  // sin^2(kappa/2), lambda = exp(-i kappa)
  Complex lambda;
  Complex u, ex, ey;
  Complex force;  // interface force
  // What the interface adds to the equations (u, ex, ey) of the block to its left and to its right.
  ComplexVector3 on_left, on_right;
};

// The chain with lengths in block lengths, stresses in e11 and forces in e11 length (thickness 1).
struct ScaledChain {
  explicit ScaledChain(const BlockChain& chain);

  Real height, e12;
  RealVector3 inertia;  // of u, ex, ey
  InterfaceForms forms;
  Real mass_over_stiffness;  // rho h L / e11 (s^2)
};

// The end block at a face, as a chain that runs on beyond it has not got it, for s^2 = `inertia_operator`.
struct ChainEnd {
  ChainEnd(const BlockChain& chain, const ScaledChain& scaled, Face face, Complex inertia_operator);

  // Equations (u, ex, ey) under a unit force on the left (side = -1) or right (1) face.
  [[nodiscard]] ComplexVector3 push(Real side) const { return {Real{1}, side * share / 2, Real{0}}; }
  // What the block's ex adds to its equations.
  [[nodiscard]] ComplexVector3 missing(Complex ex) const { return {Complex{0}, own * ex, Complex{0}}; }

  Real share;
  Complex own;
};

// All waves that decay to the right for s^2 = `inertia_operator` (1/s^2), longest waves first.
[[nodiscard]] std::vector<ChainMode> chain_modes(const ScaledChain& chain, Complex inertia_operator);

// A harmonic wave exp(i omega t) travelling along the chain under a time scheme: of all waves the least attenuated one.
struct ChainWave {
  double speed = 0;        // m/s, phase speed
  double attenuation = 0;  // 1/m, amplitude falls as exp(-attenuation x)
};
[[nodiscard]] ChainWave chain_wave(const BlockChain& chain, const TimeScheme& scheme, double dt, double omega);
// The same from sin^2(kappa/2) and the block length (m).
[[nodiscard]] ChainWave chain_wave(Complex sin2, double omega, double length);

}  // namespace exact
