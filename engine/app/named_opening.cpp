#include "engine/app/named_opening.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <set>

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

}  // namespace dda
