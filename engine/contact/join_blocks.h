// Contacts of blocks that come in while others have moved and bear stress.
//
// A block comes in as drawn and free of stress. What holds blocks together, bonded joints and those with strength,
// joins them as they are: gap and force count from there (gap_at_start, force_at_start), as mortar fills what lies
// between. Dry joints are as wide as they are: one that gapes must close first, and blocks that would lie in each other
// are seated, so that nothing presses. No contact begins with a force or an energy.
//
// A stretch of the projected law goes by the own traction of either block (projected_law.h), which a block that bears
// stress has at its face before anything touches it there: one stress cannot tell the face from the rest. So these
// tractions count from where the stretch was made as well, and nothing is taken off a block then. Dry joints of other
// laws have springs from the start.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

// The blocks of a scene when some come in.
struct ComingBlocks {
  const std::vector<bool>& absent;    // of every block whether it is not there
  const std::vector<bool>& comes_in;  // and whether it comes in now
  const State& acting;                // where forces act; in small kinematics the drawing
};

// Contacts of the drawing that blocks which come in have with those that are there, without force where blocks are.
ContactSet joined_contacts(const Model& model, const State& state, const ComingBlocks& blocks);

// Those of `joined` that stay the stretches that they are while blocks move: of pairs whose contacts do not end, 1 in
// `ends`, and whose ends have all parted by less than `reach`, m.
ContactSet holding_contacts(const Model& model, const State& state, const ContactSet& joined,
                            const std::vector<char>& ends, const std::function<double(int, int)>& reach);

// The own traction that a block of a projected stretch, a or b, had when that was made, Pa, normal and shear: none
// where both blocks were there from the start. What there is beside a block's stress is less by it.
Vec2 traction_when_joined(const InterfaceElement& element, bool of_b);

// Puts them among those that there are, in the order of the drawing. Those that there were keep stiffness and force.
// `at_rest`: gaps are those at zero displacement (linear_states.h).
void bring_in(const Model& model, const State& state, const ComingBlocks& blocks, bool at_rest, ContactSet& contacts);

// Puts contacts before the one at `place`, likewise.
void insert_contacts(const Model& model, const ContactSet& more, std::size_t place, ContactSet& contacts);

}  // namespace dda
