// States of contacts in a linear stage. There they hold their gaps at zero displacement, which is what finite
// kinematics before it left; what they are now follows from the displacements.
#pragma once

#include <cstddef>

#include "engine/contact/interface_state.h"
#include "engine/simulation/block_system.h"

namespace dda {

// The state of one interface now: in a linear stage, and in any.
InterfaceState linear_interface_state(const BlockSystem& system, std::size_t index);
InterfaceState interface_state_now(const BlockSystem& system, std::size_t index);

// Writes the states of all contacts as they are now.
void write_linear_states(BlockSystem& system);

// Sums up the internal forces of the moment anew from what blocks and contacts are, where what has been added up since
// the start does not hold any more: the moduli have changed, or corrections have ended. In any stage.
void sum_forces_of_states(BlockSystem& system);

// Goes the other way for all contacts, or for one: from states as they are now to gaps at zero displacement.
void keep_gaps_at_rest(BlockSystem& system);
void keep_gap_at_rest(const State& state, const InterfaceElement& element, InterfaceState& own);

}  // namespace dda
