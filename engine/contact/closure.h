// Whether a contact is open at all its ends, and how deep its blocks are in each other.
#pragma once

#include <vector>

#include "engine/contact/interface_element.h"
#include "engine/contact/interface_state.h"

namespace dda {

// Joints that carry the stress of their blocks are not open, whatever their ends are.
bool is_open(const InterfaceElement& element, const InterfaceState& state);

// m, at the end that is in deeper; not positive where nothing is pressed. `stress`: of all blocks, Pa.
double penetration_depth(const InterfaceElement& element, const Vec4& gap, const std::vector<Vec3>& stress);

}  // namespace dda
