// Cells that fill the blocks between joints: Voronoi polygons, fine where the plan asks for that.
#pragma once

#include <vector>

#include "engine/cutting/rock_in_blocks.h"
#include "engine/cutting/rock_plan.h"

namespace dda {

struct FilledPlan {
  RockPlan plan;  // without fills: their walls are lines that only cut
  std::vector<CutFill> fills;
  std::vector<Cleaned> cleaned;
};

// What is cut first, so that every block is filled by itself: no cell is then cut askew by a joint, an opening or the
// boundary, and a block in which not even two cells have room stays whole. Regions of fills cut, as joints and openings
// do.
RockPlan without_fills(const RockPlan& plan);

// That with cells in the blocks that have come of it.
FilledPlan with_cells(const RockPlan& plan, const std::vector<CutBlock>& blocks);

}  // namespace dda
