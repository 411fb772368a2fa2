// The contacts of a model as it is drawn.
#pragma once

#include "engine/contact/contact_set.h"
#include "engine/model/model.h"

namespace dda {

// Cubic joints become consistent ones unless all joints are bonded, all stages have small kinematics, no block is ever
// removed, no material changes and there are no bolts: only then is the inertia between blocks constant.
ContactSet make_contacts(const Model& model);

// What follows from all interfaces of a block together: rows of blocks that bend, and what projected stretches take off
// their blocks. Anew whenever interfaces have been left out.
void fit_to_neighbours(const Model& model, ContactSet& contacts);

}  // namespace dda
