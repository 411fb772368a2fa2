// What of the prolongations of free ends is of no use.
#pragma once

#include <vector>

#include "engine/cutting/plan_pieces.h"

namespace dda {

// By link: a prolongation that comes to run along another line has met it, and from there on would only add corners.
std::vector<bool> needless_prolongations(const Noding& noding, const PlanPieces& pieces);

}  // namespace dda
