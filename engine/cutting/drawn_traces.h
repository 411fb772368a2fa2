// Figures of the traces of joints as they are drawn, whether they end in the rock or cut it through: what maps of
// fractures are described by. Those of the joints between blocks are in rock_statistics.h.
#pragma once

#include <vector>

#include "engine/cutting/rock_plan.h"
#include "engine/geometry/segment.h"

namespace dda {

struct DrawnTraces {
  std::vector<Segment> pieces;  // straight pieces within the rock
  int traces = 0;               // with a piece there; one of several corners counts once
};

// Rock is what the boundary holds, without holes and openings that are left out. Construction lines are no joints, and
// lines that run along each other count each. Nothing of a plan of blocks, which has no boundary.
DrawnTraces traces_in_rock(const RockPlan& plan);

}  // namespace dda
