// Springs that get another stiffness while they carry force.
//
// The force of each spring stays as it is, and so do its blocks: the spring has force over stiffness for its gap from
// then on. Where gaps are measured, as blocks are followed, the difference is its seat (interface_state.h): the spring
// closes there until it opens for the first time, and where blocks touch from then on.
//
// A stretch of the projected law has the joint's own compliance beside that of its blocks. With it goes where its two
// points are, so that forces move to the new points, with the same sum and moment, and to the gaps of the bed that
// answers with them. From then on its gaps count from there (gap_at_start), also when it has opened.
#pragma once

#include "engine/contact/interface.h"
#include "engine/contact/interface_element.h"
#include "engine/contact/interface_state.h"
#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

// Gives springs the stiffness, and dashpots the rate, that the model has now. Elements without springs are left alone.
// `gaps_are_measured`: those of lone vertices, and of stretches of the projected law, follow from where blocks are.
void renew_springs(const Model& model, const State& state, const Interface& interface, bool gaps_are_measured,
                   InterfaceElement& element, InterfaceState& own);

// What interfaces that carry their blocks' stresses add to these blocks' strains, by the elasticities of the two that
// are in force now. Others are left alone.
void renew_strain_rows(const Mat3& elasticity_a, const Mat3& elasticity_b, InterfaceElement& element);

}  // namespace dda
