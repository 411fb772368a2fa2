// What interfaces carry of the stress that is there from the start.
#pragma once

#include "engine/contact/interface.h"
#include "engine/contact/interface_element.h"
#include "engine/model/model.h"

namespace dda {

// Normal and shear force at either end of an interface under the mean of its blocks' initial stresses, as far as a dry
// joint carries them. Springs carry these from the start.
Vec4 in_situ_force(const Model& model, const Interface& interface);

}  // namespace dda
