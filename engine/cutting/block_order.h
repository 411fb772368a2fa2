// The order of blocks, which does not depend on that of the lines around them.
#pragma once

#include <vector>

#include "engine/cutting/rock_in_blocks.h"

namespace dda {

// Rings begin at their leftmost corners; holes of a block, and blocks, are sorted by these.
void put_in_order(std::vector<CutBlock>& blocks);

}  // namespace dda
