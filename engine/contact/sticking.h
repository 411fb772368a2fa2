// Contacts of a stage of unlimited strength: which of them stick, in the course of a step.
#pragma once

#include "engine/contact/interface_trial.h"

namespace dda::sticking {

// Whether an end touched when the step began. A bed that is pressed beyond one of its points has positive gaps at both.
bool touched(const InterfaceSprings& springs, const InterfaceTrial& trial, int end);

// Contacts that just touch stick, unless the step turns out to open them: what they would carry then would be lost at
// its end, and each step would find the same forces out of balance again.
void let_go_of_opening(const InterfaceSprings& springs, InterfaceTrial& trial);

// At the start of a step: those that are open by round-off begin closed, as those that are closed by as much do, or
// what holds would be chosen by the direction in which a scene is drawn.
void close_where_touching(const InterfaceSprings& springs, InterfaceTrial& trial);

}  // namespace dda::sticking
