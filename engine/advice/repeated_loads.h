// Loads that a scene gives twice: they add up, and whoever copied an entry has twice of what was meant.
#pragma once

#include <string>
#include <vector>

#include "engine/model/model.h"

namespace dda {

// A sentence where loads on edges are the same in all: face, force, history and stages.
std::vector<std::string> repeated_loads(const Model& model);

}  // namespace dda
