// What springs at closed joints make of waves, and what would carry them better.
#pragma once

#include <string>

#include "engine/advice/advice.h"
#include "engine/model/model.h"

namespace dda {

// A sentence for scenes whose predicted waves are off by more than the wanted error because of the springs of joints,
// where the projected law can be had for them; else empty. Stiffness that is given for a joint is taken for its own.
std::string springs_in_waves(const Model& model, const Advice& advice);

}  // namespace dda
