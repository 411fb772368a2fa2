// Which edge loads of a model act on each of its blocks.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/model/model.h"

namespace dda {

// Indices of the edge loads of every block, in ascending order.
inline std::vector<std::vector<std::size_t>> edge_loads_of_blocks(const Model& model) {
  std::vector<std::vector<std::size_t>> loads(model.blocks.size());
  for (std::size_t i = 0; i < model.edge_loads.size(); ++i)
    loads[static_cast<std::size_t>(model.edge_loads[i].block)].push_back(i);
  return loads;
}

}  // namespace dda
