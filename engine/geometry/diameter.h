// How large something is, whichever way it is turned.
#pragma once

#include <vector>

#include "engine/core/types.h"

namespace dda {

// The largest distance of two of the points, m; 0 for fewer than two. Unlike the diagonal of their box it stays when
// all of them turn; of a rectangle along the axes it is that diagonal, to the bit. Takes the time of sorting the
// points.
double diameter(std::vector<Vec2> points);

}  // namespace dda
