// How far the blocks of a static step go against what carries them.
//
// A pebble on ground that sinks by many times the pebble's size goes nowhere: it lies on the ground before and after.
// What a block does by itself is its motion against the blocks that it presses on, as far as these rest: blocks that
// are held, that move by little of their own size, or that do so against what carries them in turn.
#pragma once

#include <span>
#include <vector>

#include "engine/solve/interface_trials.h"

namespace dda {

struct BlockSystem;

// How far the increments of a step move each block, in its own size (motion_share): against the block with which it
// goes best, or against nothing where that is less. Blocks carry each other that press on each other where the trials
// of the step have come to, or whose joint is among the `bonded` (places among all contacts).
std::vector<double> motion_on_carriers(const BlockSystem& system, const InterfaceTrials& trials,
                                       std::span<const int> bonded);

}  // namespace dda
