// Whether a block that is held is moved as well. (In a header of its own, since nearly every source includes model.h.)
#pragma once

#include "engine/model/model.h"

namespace dda {

inline bool moves(const HeldBlock& held) { return !held.amplitude.isZero(0) || held.turn != 0; }

}  // namespace dda
