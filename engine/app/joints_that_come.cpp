#include "engine/app/joints_that_come.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <utility>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/contact/make_contacts.h"
#include "engine/model/law_name.h"

namespace dda {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace

std::string joints_that_come(const Model& model, std::size_t stage) {
  const ContactSet drawn = make_contacts(model);
  const std::vector<bool> absent = model.absent_in(stage);
  std::vector<bool> comes(model.blocks.size(), false);
  for (const int block : model.stages[stage].rock.added) comes[at(block)] = true;
  std::map<std::pair<int, InterfaceLaw>, std::size_t> groups;
  for (std::size_t i = 0; i < drawn.interfaces.size(); ++i) {
    const Interface& each = drawn.interfaces[i];
    if (absent[at(each.block_a)] || absent[at(each.block_b)]) continue;
    if (!comes[at(each.block_a)] && !comes[at(each.block_b)]) continue;
    ++groups[{each.joint, drawn.elements.but_for_blocks(i).law}];
  }
  std::vector<std::string> parts;
  for (const auto& [group, number] : groups)
    parts.push_back(fmt::format("{} {} of \"{}\"", number, law_name(group.second), model.joints[at(group.first)].name));
  return parts.empty() ? "" : fmt::format("with joints: {}", fmt::join(parts, ", "));
}

}  // namespace dda
