// Moves the blocks at the end of a converged step.
#pragma once

#include "dda/core/types.h"
#include "dda/model/model.h"
#include "dda/model/state.h"
#include "dda/simulation/block_terms.h"
#include "dda/simulation/step_coefficients.h"

namespace dda {

// Adds the increments `d` (6 entries a block): displacements, stresses, velocities and accelerations of the integrator,
// shapes. Finite kinematics turn shapes and stresses by a finite rotation; small kinematics add the linear increments.
void move_blocks(const StepCoefficients& step, Kinematics kinematics, const BlockTerms& terms, const Eigen::VectorXd& d,
                 State& state);

}  // namespace dda
