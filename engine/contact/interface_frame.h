// Where interfaces are now that their blocks have moved.
#pragma once

#include "engine/contact/interface.h"
#include "engine/contact/interface_element.h"
#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

// Where an interface is now, in local places: its ends follow their blocks, its normal turns with the mean of the two
// edges.
InterfaceFrame current_frame(const Model& model, const State& state, const Interface& interface);

// How far block b has gone from block a at the ends of a stretch: along its normal and its tangent, m.
struct EndsApart {
  Vec2 from, to;
};
EndsApart ends_apart(const Model& model, const State& state, const Interface& interface);

// Where the forces of a stretch act. Those of consistent and projected joints act on both blocks halfway between
// them, so that they have no moment together, and a rotation of both blocks that leaves their gap as it is changes no
// row of it. Springs act on each block where they are tied to it.
InterfaceFrame acting_frame(const Model& model, const State& state, const Interface& interface, InterfaceLaw law);

}  // namespace dda
