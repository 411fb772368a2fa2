// What rows of one moment miss of the gaps of a whole step.
//
// Forces act along the rows B of the moment to which the integrator's balance belongs, the share s of the step (ADR
// 30). As blocks turn, B d is off the true change of a gap by (1/2 - s) times the change of B d over the step: at the
// pivot of a block that rocks by (s - 1/2) r^2 times the arm for a turn r, which stiff springs make a large force of
// where it is normal, and which lets the pivot creep along the face by as much each step where it is shear. So gaps
// begin the step with that change, foreseen from the velocities. The normal gap is measured at the end of the step
// where the blocks then are; of shear there is no such measure, what is foreseen is all that is ever known of it.
#pragma once

#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/core/types.h"

namespace dda {

// For contacts that are followed and whose normal gaps have just been measured. `velocity`: of each block's unknowns.
void foresee_gaps(const std::vector<Vec6>& velocity, double dt, double acts_at, ContactSet& contacts);

}  // namespace dda
