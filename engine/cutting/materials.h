// Which material blocks have.
#pragma once

#include "engine/cutting/rock_in_blocks.h"
#include "engine/cutting/rock_plan.h"

namespace dda {

// A point inside a valid polygon: the centroid where it can be.
Vec2 point_inside(const Polygon& polygon);

// Each block has that of the last region which holds a point inside it, else its own, else that of the plan. A region
// that holds none is remarked on.
void assign_materials(const RockPlan& plan, CutRock& rock);

}  // namespace dda
