// Whether a contact is open at all its ends, and how deep its blocks are in each other.
#pragma once

#include <vector>

#include "engine/contact/interface.h"
#include "engine/contact/interface_element.h"
#include "engine/contact/interface_state.h"
#include "engine/model/model.h"
#include "engine/model/state.h"

namespace dda {

// Joints that carry the stress of their blocks are not open, whatever their ends are.
bool is_open(const InterfaceElement& element, const InterfaceState& state);

// How far a contact is closed, m, at the end that is closed further; not positive where nothing is pressed. `stress`:
// of all blocks, Pa.
double penetration_depth(const InterfaceElement& element, const Vec4& gap, const std::vector<Vec3>& stress);

// How deep its blocks are in each other there, m. What presses a contact as it is drawn closes it where the blocks only
// touch, and so does what it rides up by: of that the outlines know nothing. And what outlines were in each other when
// the contact began, or were forgiven, is no closure. So it is the less of both.
double depth_in_each_other(const Model& model, const State& state, const Interface& interface,
                           const InterfaceElement& element, const InterfaceState& own);

}  // namespace dda
