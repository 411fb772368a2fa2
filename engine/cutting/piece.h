// What is cut where it meets others.
#pragma once

#include "engine/cutting/pixel.h"

namespace dda {

// A straight piece to be cut. Pieces of one straight line share their number, so that it is known later what a link
// was.
struct Piece {
  PixelSegment segment;
  int straight = 0;
};

}  // namespace dda
