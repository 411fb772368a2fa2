// Blocks by a name that several kinds of things may carry: a material, a group and a block can all be called "wall".
#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/scene/field.h"

namespace dda {

// The blocks that a name stands for as the name of each kind of thing, ascending; empty where nothing of that kind has
// this name.
struct NamedBlocks {
  std::vector<int> of_material;
  std::vector<int> of_group;
  std::vector<int> of_block;  // one, as names of blocks are given once
};

// Those blocks, where all kinds of things with the name in `field` mean the same ones; empty where nothing has it.
// Otherwise the field fails, with both kinds and how many blocks each has: whichever was taken might be the wrong one.
const std::vector<int>& only_meaning(const NamedBlocks& named, const Field& field);

}  // namespace dda
