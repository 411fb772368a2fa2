// Remarks on bolts whose numbers no bolt has: most often their unit is missing.
#pragma once

#include <string>
#include <vector>

#include "engine/model/model.h"

namespace dda {

// A sentence each, without a full stop: bolts that are stiffer than the rock they hold, softer than rubber,
// yield at what a hand pulls, or are stretched by more than the largest anchors.
std::vector<std::string> bolt_remarks(const Model& model);

}  // namespace dda
