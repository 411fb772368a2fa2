#include "engine/advice/repeated_loads.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <variant>

#include "engine/advice/block_named.h"
#include "engine/model/edge_loads_of_blocks.h"

namespace dda {
namespace {

bool is_same(const TimeFunction& a, const TimeFunction& b) {
  if (a.index() != b.index()) return false;
  if (const auto* table = std::get_if<PiecewiseLinear>(&a)) {
    const auto& other = std::get<PiecewiseLinear>(b);
    return std::tie(table->times, table->values) == std::tie(other.times, other.values);
  }
  if (const auto* sine = std::get_if<SineCycles>(&a)) {
    const auto& other = std::get<SineCycles>(b);
    return std::tie(sine->frequency, sine->cycles, sine->start) == std::tie(other.frequency, other.cycles, other.start);
  }
  if (const auto* decay = std::get_if<ExponentialDecay>(&a)) {
    const auto& other = std::get<ExponentialDecay>(b);
    return std::tie(decay->decay_time, decay->start, decay->rise) ==
           std::tie(other.decay_time, other.start, other.rise);
  }
  if (const auto* recorded = std::get_if<Recorded>(&a)) {
    const auto& other = std::get<Recorded>(b);
    return std::tie(recorded->recording, recorded->start) == std::tie(other.recording, other.start);
  }
  return true;
}

// What presses nothing can be there as often as it likes, as the part of a face above a water table.
bool is_same(const EdgeLoad& a, const EdgeLoad& b) {
  const bool presses = !a.traction.isZero(0) || !a.rise.isZero(0);
  return presses && a.from == b.from && a.to == b.to && a.traction == b.traction && a.rise == b.rise &&
         a.stages.first == b.stages.first && a.stages.last == b.stages.last && a.follows == b.follows &&
         is_same(a.history, b.history);
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
