// Contact forces as lines.
#pragma once

#include <utility>
#include <vector>

#include "engine/view/run_results.h"

namespace dda {

// Share of the largest force below which a force is not drawn.
inline constexpr double least_drawn_force = 0.01;

struct ForceLine {
  Vec2 from, to;     // m
  double force = 0;  // N per m of thickness
  bool tension = false;
};

// Area (m2, holes left out) and centroid of a block whose vertices are at `points`.
std::pair<double, Vec2> area_and_centroid(const Drawing& drawing, const std::vector<Vec2>& points, std::size_t block);

// A line of action through every closed contact. `deformation_scale`: of all motion.
std::vector<ForceLine> contact_lines(const Drawing& drawing, const std::vector<DrawnContact>& contacts,
                                     double deformation_scale);

// The resultant of all contacts of two blocks, a line in each of the blocks from its point of action. Where just two
// joints load a block from opposite sides, their lines meet half-way between them: the line of thrust. Elsewhere a line
// follows the direction of its force towards the block's centroid. `points` are the vertices as drawn, with the same
// deformation_scale.
std::vector<ForceLine> joint_lines(const Drawing& drawing, const std::vector<Vec2>& points,
                                   const std::vector<DrawnContact>& contacts, double deformation_scale);

}  // namespace dda
