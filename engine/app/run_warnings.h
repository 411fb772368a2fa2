// What else a run that went through has to say of its result.
#pragma once

#include <string>
#include <vector>

#include "engine/simulation/simulation.h"

namespace dda {

// A sentence each, beginning with "warning: ": blocks deep in each other, blocks that nothing holds, bolts and linings
// through air, water in joints that are joints no more, loads that steps pass over, blocks whose spin pulls them.
std::vector<std::string> warnings_of(const Simulation& simulation);

// What to do about two blocks that are too deep in each other.
std::string remedy_of_depth(const Model& model, int block_a, int block_b);

}  // namespace dda
