#include "engine/scene/block_sets.h"

namespace dda {

void BlockSets::list_members() const {
  for (std::size_t i = 0; i < model_.blocks.size(); ++i) {
    const Block& block = model_.blocks[i];
    const int index = static_cast<int>(i);
    members_[model_.materials[static_cast<std::size_t>(block.material)].name].of_material.push_back(index);
    members_[groups_[i]].of_group.push_back(index);
    members_[block.name].of_block.push_back(index);
  }
}

const std::vector<int>& BlockSets::members(const Field& field) const {
  if (members_.empty()) list_members();
  const auto found = members_.find(field.text());
  if (found == members_.end()) field.fail("the name of a material, a group of blocks or a block");
  return only_meaning(found->second, field);
}

}  // namespace dda
