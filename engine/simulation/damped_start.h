// The velocities with which a stage under Rayleigh damping begins.
//
// Where a velocity is out of balance with its dampers when a stage begins, as that of a block whose support moves off
// at once, they bring it into balance within a time M/C. Steps dt that are long against that time cannot follow it:
// with the velocity of before, integrators that damp little swing about the balance for good, and all of them overshoot
// in the first step. So a share of the change is made at once: with f the forces out of balance and S = M + dt C,
//
//   w = (S^-1 dt C)^2 S^-1 dt f
//
// of a vibration for which z = dt C/M this is (z/(1 + z))^3 of the way to balance: all of it where no step can follow,
// and of third order in dt where steps resolve it, which leaves integrators their second order.
#pragma once

#include <Eigen/Core>

#include "engine/simulation/block_system.h"
#include "engine/simulation/linear_operators.h"
#include "engine/simulation/rayleigh_damping.h"

namespace dda {

struct ChangeAtOnce {
  Eigen::VectorXd velocity;  // 6 numbers a block; empty where there is none
  double brought = 0;        // by what moves feet of supports and held blocks, J per m of thickness
};

// `unbalanced`: f, with nothing on held blocks. `dt` in s.
ChangeAtOnce change_at_once(const BlockSystem& system, const LinearOperators& operators, const RayleighDamping& damping,
                            double dt, const Eigen::VectorXd& unbalanced);

}  // namespace dda
