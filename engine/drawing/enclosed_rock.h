// The boundary of rock that is what lines enclose, as dc of the original DDA has it.
#pragma once

#include <string>
#include <vector>

#include "engine/cutting/rock_plan.h"

namespace dda {

// Gives the plan the outline of all that its lines enclose as its boundary, and takes away lines that lie along it
// within `reach` (m). Blocks around `points` become openings with the names of the points. `name` is the drawing's.
// Throws InputError for lines that enclose nothing, or several pieces apart, and for such a point in no block.
void enclose_rock(const std::string& name, double reach, const std::vector<PlanPoint>& points, RockPlan& plan);

}  // namespace dda
