// Blocks that are far smaller than those around them.
#pragma once

#include <cstddef>

#include "engine/simulation/block_terms.h"
#include "engine/solve/held_unknowns.h"

namespace dda {

// Whether the area of a block is less than this share of that of more than half of the blocks that can move. Among many
// stones that are all small, or beside one large block, a small one is not: it may be what the scene is about.
[[nodiscard]] bool is_below(double share, const BlockTerms& terms, const HeldUnknowns& held, std::size_t block);

}  // namespace dda
