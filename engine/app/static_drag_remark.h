// Static stages whose steps held back what moved in them.
#pragma once

#include <string>

#include "engine/simulation/simulation.h"

namespace dda {

// One sentence where inertia took a good part of what changing loads and motions did in a static stage with steps of
// its own; empty without any. Of several the worst is named.
std::string static_drag_remark(const Simulation& simulation);

}  // namespace dda
