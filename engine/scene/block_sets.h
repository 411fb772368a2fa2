// Blocks by the names that stand for several of them: materials, groups, and blocks themselves.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "engine/model/model.h"
#include "engine/scene/field.h"
#include "engine/scene/named_blocks.h"

namespace dda {

class BlockSets {
 public:
  // `groups`: of each block. The arguments must outlive it. Costs nothing until a name is looked up.
  BlockSets(const Model& model, const std::vector<std::string>& groups) : model_(model), groups_(groups) {}

  // The blocks that the name in `field` stands for, ascending; at least one. Fails where it is the name of several
  // kinds of things that stand for different blocks.
  [[nodiscard]] const std::vector<int>& members(const Field& field) const;

 private:
  void list_members() const;

  const Model& model_;
  const std::vector<std::string>& groups_;
  mutable std::unordered_map<std::string, NamedBlocks> members_;  // of every name, once one was asked for
};

}  // namespace dda
