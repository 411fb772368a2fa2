#include "engine/drawing/layers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "engine/core/error.h"

namespace dda {

const std::vector<std::string>& role_names() {
  static const std::vector<std::string> names{
      "boundary",           "rock",      "tunnel",     "removable hole", "hole point", "blast",
      "absorbing boundary", "fix point", "load point", "measure point",  "ignored"};
  return names;
}

namespace {

struct Beginning {
  LayerRole role;
  std::string_view words;
};
constexpr std::array<Beginning, 3> beginnings{
    {{LayerRole::block, "block "}, {LayerRole::block_hole, "hole of "}, {LayerRole::rock, "joint "}}};

bool is_gap(char c) { return c == ' ' || c == '_' || c == '-'; }

bool begins_with(std::string_view layer, std::string_view words) {
  const auto same = [](char a, char b) { return b == ' ' ? is_gap(a) : a == b; };
  return layer.size() > words.size() && std::ranges::equal(in_lower_case(layer.substr(0, words.size())), words, same);
}

}  // namespace

std::optional<NamedLayer> named_layer(std::string_view layer) {
  for (const auto& [role, words] : beginnings) {
    if (begins_with(layer, words)) return NamedLayer{role, std::string(layer.substr(words.size()))};
  }
  return std::nullopt;
}

std::string layer_for(const NamedLayer& named) {
  const auto* const found = std::ranges::find(beginnings, named.role, &Beginning::role);
  return std::string(found->words) + named.name;
}

std::string bare_layer(std::string_view name) {
  std::string letters;
  for (const char c : in_lower_case(name)) {
    if (!is_gap(c)) letters += c;
  }
  return letters;
}

Layers::Layers(const std::map<std::string, LayerUse>& table) {
  for (std::size_t i = 0; i < role_names().size(); ++i)
    uses_[bare_layer(role_names()[i])].role = static_cast<LayerRole>(i);
  uses_.erase(bare_layer("ignored"));
  uses_["defpoints"].role = LayerRole::ignored;
  for (const auto& [name, use] : table) uses_[bare_layer(name)] = use;
}

const LayerUse& Layers::use_of(const std::string& layer, const std::string& origin) {
  const auto found = uses_.find(bare_layer(layer));
  if (found != uses_.end()) return found->second;
  if (const auto named = named_layer(layer)) {
    const bool is_default_joint = named->name == default_joint_name;
    const bool has_joint = named->role == LayerRole::rock && !is_default_joint;
    return named_uses_.try_emplace(layer, LayerUse{named->role, has_joint ? named->name : "", false}).first->second;
  }
  std::vector<std::string> names(role_names().begin(), role_names().end() - 1);
  throw InputError("", origin, fmt::format("on the unknown layer \"{}\"", layer),
                   fmt::format("one of {0}, or a word on what it is: --layer \"{1}=rock\" for joints, --layer "
                               "\"{1}=ignored\" to leave it out, in a scene \"layers\": {{\"{1}\": \"rock\"}}",
                               fmt::join(names, ", "), layer));
}

}  // namespace dda
