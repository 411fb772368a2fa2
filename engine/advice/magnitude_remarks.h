// Remarks on numbers that rock and its surroundings hardly ever have: most often their unit is missing.
#pragma once

#include <string>
#include <vector>

#include "engine/model/model.h"

namespace dda {

// A sentence each, without a full stop: gravity, moduli and densities of materials, and the stress that blocks begin
// with.
std::vector<std::string> magnitude_remarks(const Model& model);

}  // namespace dda
