#include <fmt/format.h>

#include <algorithm>

#include "engine/scene/block_sets.h"
#include "engine/scene/places.h"
#include "engine/scene/sections.h"

namespace dda {
namespace {

// Each pair of blocks takes an entry of a map; two groups of thousands of blocks would fill the memory.
constexpr std::size_t most_pairs = 2'000'000;

void read_joint_pair(const Field& field, const BlockSets& sets, Model& model) {
  const std::vector<Field> sides = field.at("between").items();
  const std::vector<int>& first = sets.members(sides.at(0));
  const std::vector<int>& second = sets.members(sides.at(1));
  const int joint = read_joint_reference(field.at("joint"), model);
  if (first.size() * second.size() > most_pairs) {
    field.at("between").fail(fmt::format("{} times {} blocks", first.size(), second.size()),
                             fmt::format("at most {} pairs; make the commoner joint the default", most_pairs));
  }
  for (const int a : first) {
    for (const int b : second) {
      if (a != b) model.joint_of_block_pair[{std::min(a, b), std::max(a, b)}] = joint;
    }
  }
}

}  // namespace

void read_joint_pairs(const Field& scene, const std::vector<std::string>& groups, Model& model) {
  const auto pairs = scene.find("joint_pairs");
  if (!pairs) return;
  const BlockSets sets(model, groups);
  for (const Field& pair : pairs->items()) read_joint_pair(pair, sets, model);
}

}  // namespace dda
