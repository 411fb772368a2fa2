// Edges of blocks that are shorter than the tolerance: their two corners become one where all blocks around stay sound.
#pragma once

#include <vector>

#include "engine/cutting/cleaned.h"
#include "engine/cutting/corner_places.h"
#include "engine/cutting/corners.h"

namespace dda {

// The shortest first. Appends those closed to `cleaned`. `tolerance` in m.
void close_short_edges(const Arrangement& arrangement, const Corners& corners, const std::vector<NodeRings>& blocks,
                       double tolerance, CornerPlaces& places, std::vector<Cleaned>& cleaned);

}  // namespace dda
