// Reflection of plane waves at the viscous edge of an endless half space of blocks, in the frequency domain: the waves
// of the periodic mesh by Bloch analysis of the engine's matrices, and the balance of the cells on the edge with the
// engine's damping matrix. No time stepping, no other boundary.
#pragma once

#include "verification/exact/viscous_reflection.h"
#include "verification/lattice/bloch.h"

namespace verify {

// The mesh is repeated along its edge by `second`; the half space lies on the side of -`first`.
struct MeshEdge {
  PeriodicMesh mesh;
  dda::Material rock;
  dda::JointMaterial bond;
  bool corrected = false;        // for the blocks' size
  double across = 1, along = 1;  // impedances over rho c_p and rho c_s
};

struct EdgeReflection {
  double p_energy = 0, s_energy = 0;  // shares of the energy that arrives
  double absorbed = 0;                // by the power of the dashpots
};

// Lets a wave of the angular frequency `omega` arrive whose slowness along the edge is sin(angle) over the speed in the
// continuum. Throws std::runtime_error if the waves of the mesh do not part into arriving and leaving ones.
[[nodiscard]] EdgeReflection reflect(const MeshEdge& edge, exact::PlaneWave incident, double angle, double omega);

}  // namespace verify
