// A plan of rock, cut into blocks.
#pragma once

#include "engine/cutting/rock_in_blocks.h"
#include "engine/cutting/rock_plan.h"

namespace dda {

// Throws InputError, without a file, for a plan that cannot be cut: a boundary that crosses itself, an opening outside
// the rock, too many blocks.
CutRock cut_rock(const RockPlan& plan, const CutOptions& options = {});

}  // namespace dda
