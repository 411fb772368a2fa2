// What rows of one moment miss of the gaps of a whole step.
//
// Forces act along the rows B of the moment to which the integrator's balance belongs, the share s of the step (ADR
// 30). As blocks turn, B d is off the true change of a gap by (1/2 - s) times the change of B d over the step: at the
// pivot of a block that rocks by (s - 1/2) r^2 times the arm for a turn r, which stiff springs make a large force of.
// So gaps begin the step with that change, foreseen from the velocities, and end it where the blocks then are.
#pragma once

#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/core/types.h"

namespace dda {

// For normal gaps that have just been measured, of contacts that are followed. `velocity`: of each block's unknowns.
void foresee_gaps(const std::vector<Vec6>& velocity, double dt, double acts_at, ContactSet& contacts);

}  // namespace dda
