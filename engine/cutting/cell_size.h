// How large the cells of a fill are, from place to place.
#pragma once

#include <array>
#include <vector>

#include "engine/cutting/rock_plan.h"

namespace dda {

// The side (m) of the square that is as large as a cell around `place`.
double cell_size(const PlanFill& fill, const Vec2& place);

// A triangle so small that cells are of one size in it.
struct FillPart {
  std::array<Vec2, 3> corners;
  double size = 0;   // m, of cells
  double cells = 0;  // that have room in it, a fraction
};

// The polygon in such parts, neighbours near each other in the list. Throws InputError when there would be room for
// more than `most_cells`.
std::vector<FillPart> parts_of(const Polygon& polygon, const PlanFill& fill);

inline constexpr double most_cells = 100'000;  // of a fill in one block

}  // namespace dda
