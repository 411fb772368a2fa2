#include "engine/scene/named_blocks.h"

#include <fmt/format.h>

#include <utility>

namespace dda {
namespace {

std::string described(const char* kind, const std::vector<int>& blocks) {
  return fmt::format("{} ({} block{})", kind, blocks.size(), blocks.size() == 1 ? "" : "s");
}

}  // namespace

const std::vector<int>& only_meaning(const NamedBlocks& named, const Field& field) {
  const std::vector<int>* meaning = &named.of_block;
  const char* kind = "a block";
  for (const auto& [other_kind, other] :
       {std::pair("a group", &named.of_group), std::pair("a material", &named.of_material)}) {
    if (other->empty()) continue;
    if (!meaning->empty() && *meaning != *other)
      field.fail(fmt::format("\"{}\", the name of {} and of {}", field.text(), described(kind, *meaning),
                             described(other_kind, *other)),
                 "a name that means one of them; give the other another name");
    meaning = other;
    kind = other_kind;
  }
  return *meaning;
}

}  // namespace dda
