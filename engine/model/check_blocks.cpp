#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <unordered_set>

#include "engine/core/error.h"
#include "engine/core/parallel.h"
#include "engine/core/where.h"
#include "engine/geometry/fitted_groups.h"
#include "engine/geometry/near_shapes.h"
#include "engine/geometry/overlap.h"
#include "engine/model/check_parts.h"
#include "engine/model/checks.h"

namespace dda::model_checks {
namespace {

void check_initial_state(const Item& item, const Block& block) {
  item.finite("initial stress", block.initial_stress);
  item.finite("initial velocity", block.initial_velocity);
  item.finite("initial spin", block.initial_spin);
  item.finite("initial strain rate", block.initial_strain_rate);
}

// Blocks that touch along straight sides parallel to the axes, the most of them, drop out here already.
std::vector<std::pair<int, int>> suspect_pairs(const Model& model) {
  std::vector<Box> boxes;
  std::vector<const Ring*> outlines;
  for (const Block& block : model.blocks) {
    boxes.push_back(expanded(bounding_box(block.shape), -model.length_tolerance));
    outlines.push_back(&block.shape.outer);
  }
  return pairs_of_near_shapes(outlines, boxes);
}

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Blocks of cut rock are neighbours of a few others each, by sides that both have: to count sides costs less than a
// tenth of looking at pairs. Few pairs are soon looked at.
std::vector<int> known_to_fit(const std::vector<const Polygon*>& shapes) {
  constexpr std::size_t many = 20'000;
  return shapes.size() < many ? std::vector<int>(shapes.size(), no_group) : groups_that_fit(shapes);
}

bool fit(int group, int other) { return group != no_group && group == other; }

}  // namespace

void check_blocks(const Model& model) {
  if (model.blocks.empty()) throw InputError("", "blocks", "empty", "at least one block");
  constexpr std::size_t worth_sharing = 256;
  std::vector<std::optional<std::string>> defects(model.blocks.size());
  parallel_for_each(defects.size(), worth_sharing, [&](std::size_t i) { defects[i] = defect(model.blocks[i].shape); });
  std::unordered_set<std::string_view> names;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const Block& block = model.blocks[i];
    const Item item("blocks", i, block.name);
    if (defects[i]) item.fail("shape", *defects[i], "a simple polygon");
    item.index("material", block.material, model.materials.size());
    if (!block.name.empty() && !names.insert(block.name).second) {
      item.fail("name", fmt::format("\"{}\"", block.name), "a name that no other block has");
    }
  }
}

void check_initial_state(const Model& model) {
  for (std::size_t i = 0; i < model.blocks.size(); ++i)
    check_initial_state(Item("blocks", i, model.blocks[i].name), model.blocks[i]);
}

void check_overlaps(const Model& model) {
  std::vector<const Polygon*> shapes;
  for (const Block& block : model.blocks) shapes.push_back(&block.shape);
  const std::vector<int> groups = known_to_fit(shapes);
  if (std::ranges::all_of(groups, [&](int group) { return fit(group, groups.front()); })) return;
  std::vector<std::pair<int, int>> pairs = suspect_pairs(model);
  std::erase_if(pairs, [&](const auto& pair) { return fit(groups[at(pair.first)], groups[at(pair.second)]); });
  const Overlaps overlaps(std::move(shapes));
  for (const std::size_t i : numbers_where(pairs.size(), [&](std::size_t pair) {
         return overlaps.between(pairs[pair].first, pairs[pair].second, model.length_tolerance);
       })) {
    const auto& [a, b] = pairs[i];
    const Block& first = model.blocks[at(a)];
    const Block& second = model.blocks[at(b)];
    const Item item("blocks", at(b), second.name);
    item.fail("shape", fmt::format("overlapping \"{}\"", first.name), "blocks that at most touch");
  }
}

}  // namespace dda::model_checks
