// Walls between the cells of a fill in one block: the edges of the Voronoi diagram of its sites, ended at the outline
// of the block, without short ones.
#pragma once

#include <vector>

#include "engine/cutting/cell_sites.h"
#include "engine/cutting/rock_plan.h"
#include "engine/geometry/segment.h"

namespace dda {

struct CellWalls {
  std::vector<Segment> walls;
  std::vector<Cleaned> closed;  // edges shorter than the fill allows, walls or stretches of the outline between them
};

// The two ends of a short edge become one: a corner of the block stays where it is, an end on the outline stays on its
// edge, others meet half-way. So shapes of blocks do not change, and no edge is left open.
CellWalls walls_between(const std::vector<Pixel>& sites, const SiteGrid& grid, const Polygon& block,
                        const PlanFill& fill);

}  // namespace dda
