// Blocks that have something, and how sentences name them.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <vector>

#include "engine/model/model.h"

namespace dda {

// Their indices, in order.
template <typename Condition>
std::vector<int> blocks_with(const Model& model, const Condition& condition) {
  std::vector<int> found;
  for (std::size_t i = 0; i < model.blocks.size(); ++i)
    if (condition(model.blocks[i])) found.push_back(static_cast<int>(i));
  return found;
}

inline std::string block_named(const Model& model, int block) {
  return fmt::format("block \"{}\"", model.blocks[static_cast<std::size_t>(block)].name);
}

// Nothing where there are none.
inline std::string and_more(std::size_t others) { return others > 0 ? fmt::format(" and {} more", others) : ""; }

// The first of a list, and how many more there are.
inline std::string blocks_named(const Model& model, const std::vector<int>& blocks) {
  return block_named(model, blocks.front()) + and_more(blocks.size() - 1);
}

}  // namespace dda
