// How blocks that are held move. (In a header of its own, since nearly every source includes model.h.)
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "engine/model/model.h"

namespace dda {

inline bool moves(const HeldBlock& held) { return !held.amplitude.isZero(0) || held.turn != 0; }

// All entries of one block: their motions add up.
using HeldMotions = std::span<const HeldBlock>;

// Whether entries can be of one block: each moves it, and one at most turns it.
inline bool add_up(const HeldMotions& motions) {
  const auto turns = [](const HeldBlock& held) { return held.turn != 0; };
  return motions.size() < 2 || (std::ranges::all_of(motions, moves) && std::ranges::count_if(motions, turns) < 2);
}

// The entries of the block that the entry `first` is of, which is the first of its own.
inline HeldMotions motions_from(const Model& model, std::size_t first) {
  const HeldMotions rest = HeldMotions(model.held_blocks).subspan(first);
  const auto end = std::ranges::find_if(rest, [&](const HeldBlock& each) { return each.block != rest[0].block; });
  return {rest.begin(), end};
}

template <typename Visit>
void for_each_held_block(const Model& model, Visit visit) {
  for (std::size_t i = 0; i < model.held_blocks.size();) {
    const HeldMotions motions = motions_from(model, i);
    visit(motions);
    i += motions.size();
  }
}

}  // namespace dda
