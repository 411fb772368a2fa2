#include "engine/app/named_opening.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <set>

#include "engine/builder/separate_places.h"
#include "engine/core/error.h"
#include "engine/scene/nearest_word.h"

namespace dda {
namespace {

// Words of `names` as a sentence lists them, no more than a reader wants.
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 8;
  const bool all = names.size() <= most;
  const std::vector<std::string> shown(names.begin(), all ? names.end() : names.begin() + most);
  return fmt::format("{}{}", fmt::join(shown, ", "), all ? "" : ", ...");
}

// The blocks that are not there once the opening is made: its own, and those that are away then.
std::vector<bool> away_with(const std::vector<int>& opening, const Model& model) {
  const auto removes_it = [&](const Stage& stage) {
    return std::ranges::find(stage.removal.blocks, opening.front()) != stage.removal.blocks.end();
  };
  const auto stage = static_cast<std::size_t>(std::ranges::find_if(model.stages, removes_it) - model.stages.begin());
  std::vector<bool> away = model.absent_in(stage < model.stages.size() ? stage : 0);
  away.resize(model.blocks.size(), false);
  for (const int block : opening) away[static_cast<std::size_t>(block)] = true;
  return away;
}

}  // namespace

void refuse_opening(const std::string& name, const SceneParts& scene) {
  std::set<std::string> openings;
  for (const PlanOpening& opening : scene.openings) openings.insert(opening.name);
  std::set<std::string> all(scene.groups.begin(), scene.groups.end());
  all.insert(openings.begin(), openings.end());
  const std::set<std::string>& known = openings.empty() ? all : openings;
  const std::string meant = nearest_word(name, std::vector<std::string>(all.begin(), all.end()));
  const std::string hint = meant.empty() ? "" : fmt::format(" (\"{}\"?)", meant);
  throw InputError("", "--opening", "\"" + name + "\"",
                   fmt::format("the name of an opening or of a group of blocks{}: {}", hint,
                               listed(std::vector<std::string>(known.begin(), known.end()))));
}

std::vector<int> blocks_of_opening(const std::string& name, const SceneParts& scene) {
  std::vector<int> blocks;
  for (std::size_t i = 0; i < scene.groups.size(); ++i)
    if (scene.groups[i] == name) blocks.push_back(static_cast<int>(i));
  if (!blocks.empty()) return blocks;
  if (std::ranges::find(scene.openings, name, &PlanOpening::name) == scene.openings.end()) refuse_opening(name, scene);
  throw InputError("", "--opening", fmt::format("\"{}\", which has no blocks inside", name),
                   "an opening that is not left_out, so that its rock can be taken out");
}

void expect_one_opening(const std::string& name, const std::vector<int>& blocks, const Model& model) {
  const auto places = separate_places(blocks, away_with(blocks, model), model);
  if (places.size() < 2) return;
  throw InputError("", "--opening", in_several_places(name, places, model),
                   "an opening with one wall, which has a crown and an invert: a group for each place");
}

}  // namespace dda
