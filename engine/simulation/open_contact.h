// Whether a contact is open at all its ends.
#pragma once

#include "engine/contact/interface_element.h"
#include "engine/contact/interface_state.h"

namespace dda {

// Joints that carry the stress of their blocks are not open, whatever their ends are.
inline bool is_open(const InterfaceElement& element, const InterfaceState& state) {
  if (has_stress_rows(element)) return false;
  const bool second_open = element.length == 0 || state.status[1] == ContactStatus::open;
  return state.status[0] == ContactStatus::open && second_open;
}

}  // namespace dda
