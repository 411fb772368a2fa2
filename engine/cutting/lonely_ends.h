// Ends of lines that have nothing near them: to prolong such an end is of no use, as what sticks out meets nothing and
// is trimmed.
#pragma once

#include <vector>

#include "engine/cutting/piece.h"
#include "engine/cutting/rock_plan.h"

namespace dda {

// By piece: whether it prolongs a line from an end that no other line comes near. Pieces stay that might meet anything
// when places move by round-off, and those where what is left out would change the rounding of sums: beyond the box of
// the boundary and in openings that are left out.
//
// `pieces`: a piece of each straight as drawn, then those that prolong it. `tolerance`: m, by which they do.
std::vector<bool> lonely_prolongations(const std::vector<Piece>& pieces, const PixelGrid& grid, double tolerance,
                                       const RockPlan& plan);

}  // namespace dda
