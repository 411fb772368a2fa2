// The quadratic forms of one interface of the block chain, split by its mirror symmetry and scaled.
#pragma once

#include <Eigen/Core>

#include "verification/exact/block_chain.h"
#include "verification/exact/time_scheme.h"

namespace exact {

using RealMatrix3 = Eigen::Matrix<Real, 3, 3>;
using RealVector3 = Eigen::Matrix<Real, 3, 1>;

// Between blocks 0 and 1 a motion has a part that its mirror image repeats and one that its mirror image reverses:
//   opening x = (g, ex_0 + ex_1, ey_0 + ey_1), g the normal gap
//   bending x = (u_0 + u_1, ex_1 - ex_0, ey_1 - ey_0).
// Each part has the energies x^T stiffness x/2 and x'^T inertia x'/2. Lengths in block lengths, stresses in e11, mass
// in that of a block.
struct InterfaceForms {
  RealMatrix3 opening_stiffness = RealMatrix3::Zero(), opening_inertia = RealMatrix3::Zero();
  RealMatrix3 bending_stiffness = RealMatrix3::Zero(), bending_inertia = RealMatrix3::Zero();
  RealVector3 force = RealVector3::Zero();  // the probe interface_force from the opening part
  int waves = 1;                            // that decay to one side: the rank of the coupling of neighbours
};

[[nodiscard]] InterfaceForms interface_forms(const BlockChain& chain);

}  // namespace exact
