// Blocks of a drawing, each with an outline of its own.
#pragma once

#include <string>
#include <vector>

#include "engine/cutting/rock_plan.h"

namespace dda {

struct DrawnRing {
  Ring ring;
  std::string group;
  std::string material;  // empty: the drawing does not say it
  std::string origin;
};

// Closed lines as rings; ends nearer than `reach` (m) are one, which is noted. Throws InputError for a line that does
// not close.
Ring closed_ring(std::vector<Vec2> points, const std::string& origin, double reach, std::vector<Cleaned>& cleaned);

// Each hole belongs to the smallest block of its group around it: the outline of a block that fills a hole lies along
// the hole, not around it. Throws InputError for a hole that is in no block.
std::vector<PlanBlock> blocks_with_holes(std::vector<DrawnRing> outlines, std::vector<DrawnRing> holes);

}  // namespace dda
