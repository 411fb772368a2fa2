// The blocks' acceleration at the start of a dynamic stage in which contacts can change.
#pragma once

#include <vector>

#include "engine/simulation/block_system.h"

namespace dda {

// From the forces at that moment, without those that constrain, each block on its own: M a = F. What presses a light
// block against a stiff contact is let go within far less than a step; there (M + dt^2 K) a = F, with the stiffness K
// that the pressed contacts hold the block by and that it has itself, is its acceleration on average over the step,
// taken where the other would move the block by more than `harmless` in a step, in the block's own size. With M alone,
// or where ends slide with that of the contacts alone, dt a would be a velocity that nothing has. The same holds of a
// small block that nothing presses any more and that has a stress left, as one that was held while others settled. Such
// blocks are taken together: each on its own would be held by neighbours that go along with it, as in a row that begins
// to slide, which then lost half of its first step. `changing`: the interfaces of the system that can change.
void set_initial_acceleration(const std::vector<int>& changing, double harmless, BlockSystem& system);

}  // namespace dda
