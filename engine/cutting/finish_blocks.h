// From outlines to the polygons of blocks: superfluous corners go, corners nearer than the tolerance become one.
#pragma once

#include <vector>

#include "engine/cutting/rock_in_blocks.h"
#include "engine/cutting/trace.h"

namespace dda {

// Fills blocks and joints of `rock` and notes edges that were closed. Corners are shared to the last bit. `groups` have
// settled.
void finish_blocks(const Arrangement& arrangement, const FaceGroups& groups, const std::vector<FacePlace>& places,
                   const std::vector<Outline>& outlines, const PlanPieces& pieces, const RockPlan& plan, CutRock& rock);

}  // namespace dda
