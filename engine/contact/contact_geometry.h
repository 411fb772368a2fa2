// Contacts follow their blocks.
#pragma once

#include "engine/contact/contact_set.h"
#include "engine/contact/interface.h"
#include "engine/contact/interface_state.h"
#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

// The gap of a consistent interface follows from where its blocks are and not from the way there, or rock that was
// deformed and is left alone would keep stresses. Increments along rows that turn would miss a share of it, the strain
// of the blocks times the gap. So does that of a projected one (projected_stretch.h). For an element whose rows are
// those of now.
void measure_gap(const Model& model, const State& state, const Interface& interface, const InterfaceElement& element,
                 InterfaceState& own);

// Finite kinematics: moves the elements to where forces act, the geometry of `acting`, and measures the gaps of
// consistent and projected interfaces in `state`.
void update_geometry(const Model& model, const State& state, const State& acting, ContactSet& contacts);

// Lets projected stretches go on with their forces as they are. To be called before the first measurement after small
// kinematics, whose gaps are of first order in the turns of blocks.
void keep_gaps(const Model& model, const State& state, ContactSet& contacts);

}  // namespace dda
