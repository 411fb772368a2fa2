// Says of every block whether it is held as a whole: Model::is_held for loops over all blocks or contacts of a scene.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/model/model.h"

namespace dda {

inline std::vector<bool> held_flags(const Model& model) {
  std::vector<bool> held(model.blocks.size(), false);
  for (const HeldBlock& each : model.held_blocks) held[static_cast<std::size_t>(each.block)] = true;
  return held;
}

}  // namespace dda
