// Cells that fill the blocks between joints: Voronoi polygons, fine where the plan asks for that.
#pragma once

#include "engine/cutting/cut_rock.h"

namespace dda {

struct FilledPlan {
  RockPlan plan;  // without fills: their walls are lines that only cut
  std::vector<CutFill> fills;
  std::vector<Cleaned> cleaned;
};

// The plan is cut without its fills first, and every block is filled by itself: so no cell is cut askew by a joint, an
// opening or the boundary, and a block in which not even two cells have room stays whole.
FilledPlan with_cells(const RockPlan& plan, const CutOptions& options);

}  // namespace dda
