// The half block between the last centroid of a cubic chain and its free or loaded face.
//
// Nothing lies beyond the face to reach a cubic to, so displacements are straight lines there, as in any block. Taken
// as they come, with h the half length and k a wavenumber, the end answers a wave 0.131 (k h)^3 late: it misses the
// parabola that the strain of the face asks for. Let the strain count in the potential of the half block, and in the
// work of loads on it, by a share s: both static balances stay what they are, and the end's equations (u, e) under a
// force F on the face are, per rho = Q = width = 1,
//   -k^2 (h u - h^2/2 e) + N_u = F,     -k^2 (-h^2/2 u + h^3/3 e) + s h e + N_e = -s h F
// with N of the chain. A static strain at the end dies out in the chain by 3 - sqrt(8) from block to block and meets
// (sqrt(2)/6) h of stiffness; with that, the error of third order of the reflection and of a load's wave vanishes when
//   (s - 2/3) (s + sqrt(2)/6) = (s - 1/2)^2,     s = (10 - sqrt(2))/12.
// What is left is of fourth order in amplitude and of fifth in phase. No unknowns are added, and no rates of the load.
//
// The correction for time steps (cubic_inertia.h) is M - epsilon dt^2 K here too, capped as that of the jump of the
// strains.
#pragma once

#include <cstddef>
#include <numbers>
#include <vector>

#include "engine/contact/interface.h"
#include "engine/contact/interface_elements.h"
#include "engine/core/types.h"
#include "engine/model/model.h"

namespace dda {

namespace cubic {

inline constexpr double end_share = (10 - std::numbers::sqrt2) / 12;  // s above

}  // namespace cubic

struct ChainEnd {
  int block = 0;
  std::size_t interface = 0;  // the only one that the block has
  Vec2 outward;               // unit, along the chain
  double half_length = 0;     // m, from the centroid to the face
  double width = 0;           // m
};

// Ends of the chains of cubic interfaces where nothing holds the chain: of blocks with one interface, without viscous
// edge and without support that acts along the chain. (What holds a face answers its motion, of which the share knows
// nothing: straight lines stay there.)
std::vector<ChainEnd> free_chain_ends(const Model& model, const std::vector<Interface>& interfaces,
                                      const InterfaceElements& elements);

// What the end adds to the stiffness of its block, to its inertia, to its internal force at `stress` (Pa), to the
// energy stored at that (J per m of thickness), and to a force (N) on its point `offset` from the centroid.
Mat6 end_stiffness(const Model& model, const ChainEnd& end);
Mat6 end_inertia(const Model& model, const ChainEnd& end, const Interface& interface, double period_error, double dt);
Vec6 end_force(const Model& model, const ChainEnd& end, const Vec3& stress);
double end_energy(const Model& model, const ChainEnd& end, const Vec3& stress);
Vec6 end_load(const ChainEnd& end, const Vec2& offset, const Vec2& force);

}  // namespace dda
