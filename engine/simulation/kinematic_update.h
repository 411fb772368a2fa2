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
// from the integrator. Strains, their rates and stresses stay in the directions in which the step saw them.
void advance_blocks(const StepCoefficients& step, const BlockTerms& terms, const Eigen::VectorXd& d, State& state);

// Carries the increments into the blocks' shapes: finite kinematics turn them by a finite rotation, small kinematics
// add the linear increments.
void deform_blocks(Kinematics kinematics, const Eigen::VectorXd& d, const BlockTerms& terms, State& state);

// Small kinematics, of one block.
inline void deform_small(const Vec6& d, Mat2& deformation) {
  deformation(0, 0) += d(3);
  deformation(0, 1) += d(5) / 2 - d(2);
  deformation(1, 0) += d(5) / 2 + d(2);
  deformation(1, 1) += d(4);
}

// Spins that keep their angular momentum after the blocks have changed their shapes (finite kinematics).
void keep_angular_momenta(const Model& model, State& state, BlockTerms& terms);

// Where the blocks are at the `share` of a step of `dt` (s) if they go on as they move now, each as a rigid body:
// displacements and shapes of `acting`, whose velocities are those that were believed. A block that would turn by more
// than `most_turn` (rad) in the step is not believed to: small ones between stiff contacts have velocities that no
// motion follows.
void foresee(const State& state, double dt, double share, double most_turn, State& acting);

// Brings the blocks to the geometry in which the next step's forces act: stresses, rates of strains and inertia turn
// into the directions that the blocks have there. Areas and inertia are measured anew where shapes have changed much,
// or, if `measure`, everywhere.
void follow_blocks(const Model& model, const State& acting, bool measure, State& state, BlockTerms& terms);

// Turns the same into the directions that the blocks have now, where a step has ended.
void turn_strains_home(State& state, BlockTerms& terms);

// What spin does to the strains, as the blocks move now.
void set_centrifugal_forces(const Model& model, const State& state, BlockTerms& terms);

// Adds these forces to `force`, 6 entries a block.
void add_centrifugal_forces(const BlockTerms& terms, Eigen::VectorXd& force);

// What they do in increments `d`. It comes out of the spin.
double centrifugal_work(const BlockTerms& terms, const Eigen::VectorXd& d);

}  // namespace dda
