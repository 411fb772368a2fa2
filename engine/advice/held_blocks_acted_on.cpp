#include "engine/advice/held_blocks_acted_on.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/advice/block_named.h"
#include "engine/core/place_in_words.h"
#include "engine/model/held_flags.h"
#include "engine/model/tolerance.h"

namespace dda {
namespace {

constexpr std::size_t most_sentences = 4;  // on loads: a field of tractions may have a load for every block

bool are_one_load(const EdgeLoad& a, const EdgeLoad& b) {
  constexpr double round_off = 1e-9;
  const double size = a.traction.norm();
  return a.history.index() == b.history.index() && std::abs(size - b.traction.norm()) <= round_off * size;
}

// Whether another load pushes back across the same stretch, as the water in a joint does: it is there for the block
// across, and that the held one takes its part is as it should be.
bool pushes_both_ways(const EdgeLoad& load, const Model& model) {
  constexpr double round_off = 1e-9;
  return std::ranges::any_of(model.edge_loads, [&](const EdgeLoad& other) {
    return other.block != load.block &&
           (other.from + other.to - load.from - load.to).norm() <= 2 * point_tolerance(model) &&
           (other.traction + load.traction).norm() <= round_off * load.traction.norm();
  });
}

// Stretches of one load, by whether held blocks take them; lengths in m.
struct Stretches {
  double held = 0, all = 0;
  int first_held = -1;

  void add(const Model& model, const std::vector<bool>& held_blocks, const EdgeLoad& load) {
    const double length = (load.to - load.from).norm();
    all += length;
    if (!held_blocks[static_cast<std::size_t>(load.block)] || pushes_both_ways(load, model)) return;
    held += length;
    if (first_held < 0) first_held = load.block;
  }
};

void add_edge_loads(const Model& model, const std::vector<bool>& held, std::vector<std::string>& sentences) {
  const std::vector<EdgeLoad>& loads = model.edge_loads;
  for (std::size_t i = 0; i < loads.size();) {
    const EdgeLoad& first = loads[i];
    Stretches stretches;
    for (; i < loads.size() && are_one_load(first, loads[i]); ++i) stretches.add(model, held, loads[i]);
    if (stretches.held == 0 || first.traction.isZero(0)) continue;
    sentences.push_back(fmt::format(
        "the load of {:g} Pa lies with {:.3g} % of its {:.3g} m on {}, which is held: that part moves nothing",
        first.traction.norm(), 100 * stretches.held / stretches.all, stretches.all,
        block_named(model, stretches.first_held)));
  }
}

void add_point_loads(const Model& model, const std::vector<bool>& held, std::vector<std::string>& sentences) {
  for (const PointLoad& load : model.point_loads)
    if (held[static_cast<std::size_t>(load.block)] && !load.force.isZero(0))
      sentences.push_back(
          fmt::format("all of the load of [{:g}, {:g}] N at {} is on {}, which is held: it "
                      "moves nothing",
                      load.force.x(), load.force.y(), place_in_words(load.point), block_named(model, load.block)));
}

void add_supports(const Model& model, const std::vector<bool>& held, std::vector<std::string>& sentences) {
  const auto is_idle = [&](const PointSupport& support) -> bool {
    return held[static_cast<std::size_t>(support.block)];
  };
  const auto first = std::ranges::find_if(model.supports, is_idle);
  if (first == model.supports.end()) return;
  sentences.push_back(fmt::format(
      "{} of {} springs of supports are on blocks that are held, the first on {}: they do "
      "nothing there",
      std::ranges::count_if(model.supports, is_idle), model.supports.size(), block_named(model, first->block)));
}

}  // namespace

std::vector<std::string> acting_on_held_blocks(const Model& model) {
  std::vector<std::string> sentences;
  if (model.held_blocks.empty()) return sentences;
  const std::vector<bool> held = held_flags(model);
  add_edge_loads(model, held, sentences);
  add_point_loads(model, held, sentences);
  if (sentences.size() > most_sentences) {
    const std::size_t more = sentences.size() - most_sentences + 1;
    sentences.resize(most_sentences - 1);
    sentences.push_back(fmt::format("{} more loads lie on blocks that are held, in whole or in part", more));
  }
  add_supports(model, held, sentences);
  return sentences;
}

}  // namespace dda
