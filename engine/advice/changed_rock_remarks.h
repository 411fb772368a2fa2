// Remarks on stages that give materials other moduli (model/rock_change.h).
#pragma once

#include <string>
#include <vector>

#include "engine/model/model.h"

namespace dda {

// A sentence each, without a full stop: moduli softer than any soil, and what this program foretells by the moduli that
// the rock has at the start although a dynamic stage has others.
std::vector<std::string> changed_rock_remarks(const Model& model);

}  // namespace dda
