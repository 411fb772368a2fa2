#include <fmt/format.h>

#include <algorithm>

#include "engine/scene/places.h"
#include "engine/scene/sections.h"

namespace dda {
namespace {

// Each pair of blocks takes an entry of a map; two groups of thousands of blocks would fill the memory.
constexpr std::size_t most_pairs = 2'000'000;

std::vector<int> members_of(const Field& field, const std::vector<std::string>& groups, const Model& model) {
  const std::string name = field.text();
  std::vector<int> members;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const Block& block = model.blocks[i];
    const std::string& material = model.materials[static_cast<std::size_t>(block.material)].name;
    if (block.name == name || groups[i] == name || material == name) members.push_back(static_cast<int>(i));
  }
  if (members.empty()) field.fail("the name of a material, a group of blocks or a block");
  return members;
}

void read_joint_pair(const Field& field, const std::vector<std::string>& groups, Model& model) {
  const std::vector<Field> sides = field.at("between").items();
  const std::vector<int> first = members_of(sides.at(0), groups, model);
  const std::vector<int> second = members_of(sides.at(1), groups, model);
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
  for (const Field& pair : pairs->items()) read_joint_pair(pair, groups, model);
}

}  // namespace dda
