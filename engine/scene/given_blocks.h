// Blocks that stand for an entry of a scene's "blocks": those of cut rock, half a million of which are soon written but
// slow as parts of a document.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/model/model.h"

namespace dda {

struct GivenBlocks {
  std::size_t entry = 0;  // of "blocks"; it is the first of them, and says what all have in common
  std::vector<Block> blocks;
  std::vector<std::string> groups;  // of each
};

}  // namespace dda
