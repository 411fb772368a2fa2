// The last value of each enumeration that archives take, for reading to check what it finds.
#pragma once

#include "engine/contact/interface_state.h"
#include "engine/linear/solver_choice.h"
#include "engine/model/material.h"
#include "engine/simulation/released_forces.h"
#include "engine/simulation/small_motion.h"

namespace dda {

constexpr bool last_of(bool /*any*/) { return true; }
constexpr ContactStatus last_of(ContactStatus /*any*/) { return ContactStatus::open; }
constexpr InterfaceLaw last_of(InterfaceLaw /*any*/) { return InterfaceLaw::projected; }
constexpr Released last_of(Released /*any*/) { return Released::lining; }
constexpr SmallMotionFault last_of(SmallMotionFault /*any*/) { return SmallMotionFault::may_have_passed; }
constexpr SolverKind last_of(SolverKind /*any*/) { return SolverKind::petsc; }

}  // namespace dda
