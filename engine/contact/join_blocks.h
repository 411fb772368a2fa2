// Contacts of blocks that come in while others have moved and bear stress.
//
// A block comes in as drawn and free of stress. What holds blocks together, bonded joints and those with strength,
// joins them as they are: gap and force count from there (gap_at_start, force_at_start), as mortar fills what lies
// between. Dry joints are as wide as they are: one that gapes must close first, and blocks that would lie in each other
// are seated, so that nothing presses. No contact begins with a force or an energy. Dry joints and those of the
// projected law have springs from the start, since the latter takes off its blocks stress that they had before they
// touched.
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

// Those between blocks that a joint with strength holds together whose ends have all parted by less than `reach`, m.
ContactSet holding_contacts(const Model& model, const State& state, const ComingBlocks& blocks,
                            const std::function<double(int, int)>& reach);

// Puts them among those that there are, in the order of the drawing. Those that there were keep stiffness and force.
// `at_rest`: gaps are those at zero displacement (linear_states.h).
void bring_in(const Model& model, const State& state, const ComingBlocks& blocks, bool at_rest, ContactSet& contacts);

// Puts contacts before the one at `place`, likewise.
void insert_contacts(const Model& model, const ContactSet& more, std::size_t place, ContactSet& contacts);

}  // namespace dda
