// Loads and prescribed motions that change at times at which they do not act, as a blast at 0 s that acts from a stage
// on which begins at 100 s: the clock of histories is that of the scene. And those that are zero all the time.
#pragma once

#include <string>
#include <vector>

#include "engine/model/model.h"

namespace dda {

// A sentence each, without a full stop; one for all loads and motions with the same times.
std::vector<std::string> idle_loads(const Model& model);

}  // namespace dda
