// The element of an interface under its law: stiffness, levers and rows of each law are in rooms of their own
// (cubic_law.h, projected_law.h), those of springs and of the consistent law here.
#pragma once

#include "engine/contact/interface.h"
#include "engine/contact/interface_element.h"
#include "engine/model/model.h"

namespace dda {

// The weight of a block's stress in a consistent joint's mean of both. A held block is rigid and knows of no stress:
// the other's counts.
double stress_share(const Model& model, int block, int other);

// An element with everything but the geometry, which set_geometry fills.
InterfaceElement make_element(const Model& model, const Interface& interface, InterfaceLaw law);
void set_geometry(const Model& model, const InterfaceFrame& frame, InterfaceElement& element);

}  // namespace dda
