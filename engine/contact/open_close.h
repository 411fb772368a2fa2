// The open-close iteration on one interface: which of its ends are open, sliding or stuck at the end of a step.
#pragma once

#include "dda/contact/interface_element.h"
#include "dda/contact/interface_state.h"
#include "dda/core/types.h"

namespace dda {

// 1 for rows that carry stiffness under these statuses, 0 for the others.
Vec4 active_rows(const InterfaceElement& element, const InterfaceState& state);

// The interface forces at the end of the step if the blocks did not move, with the statuses of `trial`: the part of the
// end-of-step force that does not depend on the unknowns. Sliding friction is that of the previous pass, kept in
// trial.force.
Vec4 force_without_motion(const InterfaceElement& element, const InterfaceState& start, const InterfaceState& trial);

// Judges a trial solution. `start` is the state at the start of the step, `gap_change` the solved change of its gaps,
// `stress_a` and `stress_b` the blocks' end-of-step stresses (not read in the classical law). Sets statuses, forces,
// gaps and slip of `trial`, and returns whether the next pass must differ: a status changed, or a friction force by
// more than `friction_tolerance` (relative to its normal force).
bool judge(const InterfaceElement& element, const EndStrength& strength, const InterfaceState& start,
           const Vec4& gap_change, const Vec3& stress_a, const Vec3& stress_b, double friction_tolerance,
           InterfaceState& trial);

// True when a consistent interface is loaded beyond the strength of its joint and must go on as a classical one: when
// either end, with its share of the normal force and of the moment, and half the shear force, is.
bool beyond_strength(const EndStrength& strength, const InterfaceState& trial);

}  // namespace dda
