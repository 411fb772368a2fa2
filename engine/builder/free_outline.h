// The outline of blocks where nothing touches them, as closed rings: openings in the rock and the outside of it.
#pragma once

#include <vector>

#include "engine/builder/ground_plan.h"
#include "engine/model/model.h"

namespace dda {

// Stretches one behind the other, each from where the one before ends, with the material on the left.
using FreeRing = std::vector<Stretch>;

// All closed rings of free outline of a model whose blocks are complete, each once. Where more than two free stretches
// meet in a point, a ring stays at the empty space it is along.
std::vector<FreeRing> free_rings(const Model& model);

// The ring that surrounds the empty space around `point`, the tightest; empty when `point` is not in an opening. Blocks
// that lie in the opening without touching its walls have rings of their own.
FreeRing ring_around(const std::vector<FreeRing>& rings, const Vec2& point);

// The rings that have the blocks inside, in their order, but for those of blocks that lie in openings.
FreeRing outer_rings(const std::vector<FreeRing>& rings);

}  // namespace dda
