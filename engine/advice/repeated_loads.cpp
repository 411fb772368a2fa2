#include "engine/advice/repeated_loads.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "engine/advice/block_named.h"
#include "engine/model/edge_loads_of_blocks.h"
#include "engine/model/same_history.h"

namespace dda {
namespace {

// What presses nothing can be there as often as it likes, as the part of a face above a water table.
bool is_same(const EdgeLoad& a, const EdgeLoad& b) {
  const bool presses = !a.traction.isZero(0) || !a.rise.isZero(0);
  return presses && a.from == b.from && a.to == b.to && a.traction == b.traction && a.rise == b.rise &&
         a.stages.first == b.stages.first && a.stages.last == b.stages.last && a.follows == b.follows &&
         are_same(a.history, b.history);
}

bool is_repeated(const std::vector<std::size_t>& loads, std::size_t place, const Model& model) {
  const EdgeLoad& load = model.edge_loads[loads[place]];
  return std::any_of(loads.begin(), loads.begin() + static_cast<std::ptrdiff_t>(place),
                     [&](std::size_t earlier) { return is_same(model.edge_loads[earlier], load); });
}

}  // namespace

std::vector<std::string> repeated_loads(const Model& model) {
  std::vector<int> pressed;
  const auto loads = edge_loads_of_blocks(model);
  for (std::size_t block = 0; block < loads.size(); ++block)
    for (std::size_t i = 1; i < loads[block].size(); ++i)
      if (is_repeated(loads[block], i, model)) {
        pressed.push_back(static_cast<int>(block));
        break;
      }
  if (pressed.empty()) return {};
  return {fmt::format("the same load acts twice on {}, and adds up: leave one of the two out, or take twice the load",
                      blocks_named(model, pressed))};
}

}  // namespace dda
