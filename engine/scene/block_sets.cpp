#include "engine/scene/block_sets.h"

namespace dda {

void BlockSets::list_members() const {
  for (std::size_t i = 0; i < model_.blocks.size(); ++i) {
    const Block& block = model_.blocks[i];
    const std::string& material = model_.materials[static_cast<std::size_t>(block.material)].name;
    const int index = static_cast<int>(i);
    for (const std::string* name : {&block.name, &groups_[i], &material}) {
      std::vector<int>& members = members_[*name];
      if (members.empty() || members.back() != index) members.push_back(index);
    }
  }
}

const std::vector<int>& BlockSets::members(const Field& field) const {
  if (members_.empty()) list_members();
  const auto found = members_.find(field.text());
  if (found == members_.end()) field.fail("the name of a material, a group of blocks or a block");
  return found->second;
}

}  // namespace dda
