// Moves the blocks at the end of a converged step.
#pragma once

#include <vector>

#include "engine/contact/interface_element.h"
#include "engine/core/types.h"
#include "engine/model/model.h"
#include "engine/model/state.h"
#include "engine/simulation/block_terms.h"
#include "engine/simulation/step_coefficients.h"

namespace dda {

// Adds the increments `d` (6 entries a block) to displacements and stresses, and takes velocities and accelerations
// from the integrator. Stresses stay in the directions of the step's start, which is where its forces are in balance.
void advance_blocks(const StepCoefficients& step, const BlockTerms& terms, const Eigen::VectorXd& d, State& state);

// Carries the increments into the blocks' shapes: finite kinematics turn them by a finite rotation, small kinematics
// add the linear increments.
void deform_blocks(Kinematics kinematics, const Eigen::VectorXd& d, State& state);

// Turns stresses with their blocks, from the rotations and strains `turned` (the last four unknowns, one entry a block)
// that they have followed so far. What the strains since then added came while the block turned, so it turns by half.
void turn_stresses(const BlockTerms& terms, State& state, std::vector<Vec4>& turned);

}  // namespace dda
