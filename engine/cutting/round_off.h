// What counts as round-off of whoever computed a drawing.
#pragma once

#include <algorithm>

#include "engine/cutting/plan_pieces.h"

namespace dda {

inline constexpr double least_steps_of_round_off = 4;  // of the grid: twice what rounding moves a node, on either side

// A hundredth of the tolerance, and no less than some steps of the grid, m.
inline double round_off_of(const PlanPieces& pieces) {
  constexpr double share_of_tolerance = 1e-2;
  return std::max(share_of_tolerance * pieces.tolerance, least_steps_of_round_off * pieces.grid.step());
}

// The same in steps of the grid, with room for rounding: what is not crowded within these has nothing to be welded.
inline double steps_of_round_off(const PlanPieces& pieces) {
  return round_off_of(pieces) / pieces.grid.step() + least_steps_of_round_off;
}

}  // namespace dda
