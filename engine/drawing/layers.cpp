#include "engine/drawing/layers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engine/core/error.h"

namespace dda {

const std::vector<std::string>& role_names() {
  static const std::vector<std::string> names{
      "boundary",           "rock",      "tunnel",     "removable hole", "hole point", "blast",
      "absorbing boundary", "fix point", "load point", "measure point",  "ignored"};
  return names;
}

std::string bare_layer(std::string_view name) {
  std::string letters;
  for (const char c : name) {
    if (c == ' ' || c == '_' || c == '-') continue;
    letters += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
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

const LayerUse& Layers::use_of(const std::string& layer, const std::string& origin) const {
  const auto found = uses_.find(bare_layer(layer));
  if (found != uses_.end()) return found->second;
  std::vector<std::string> names(role_names().begin(), role_names().end() - 1);
  throw InputError("", origin, fmt::format("on the unknown layer \"{}\"", layer),
                   fmt::format("one of {}, or an entry of \"layers\" (--layer) for it", fmt::join(names, ", ")));
}

}  // namespace dda
