// How large most blocks are: what is far smaller than these is a splinter.
#pragma once

#include <vector>

#include "engine/simulation/block_terms.h"
#include "engine/solve/held_unknowns.h"

namespace dda {

// The largest area, m2, that more than half of the blocks that can move have at least; 0 where none can. Among many
// stones that are all small, or beside one large block, a small one is not far below it: it may be what the scene is
// about. `room` is for the areas, and nothing is in it before or after that counts.
[[nodiscard]] double area_of_most(const BlockTerms& terms, const HeldUnknowns& held, std::vector<double>& room);

}  // namespace dda
