// Loads and prescribed motions that change so fast that time steps pass over them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/advice/load_finding.h"
#include "engine/model/model.h"

namespace dda {

// Root mean square of what is left of a history between `from` and `to` (s) when it is known at the ends of steps alone
// and taken as straight between them, over that of the history itself; 0 for a history of zeros. Sines: 1 with two
// steps in a period that meet its zeros, 0.36 with three, 0.21 with four, 0.05 with eight.
// All that is longer than an eighth of `shortest` is found.
double unseen_share(const std::function<double(double)>& history, double from, double to, double dt, double shortest);

// One for every history of which a stage sees too little, and their sentences alone.
std::vector<LoadFinding> unseen_load_findings(const Model& model);
std::vector<std::string> unseen_loads(const Model& model);

}  // namespace dda
