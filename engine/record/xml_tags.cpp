#include "engine/record/xml_tags.h"

#include <array>
#include <utility>

namespace dda {
namespace {

std::string unescaped(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, char>, 4> entities = {
      {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}}};
  std::string plain;
  while (!text.empty()) {
    char c = text.front();
    std::size_t length = 1;
    for (const auto& [entity, character] : entities) {
      if (!text.starts_with(entity)) continue;
      c = character;
      length = entity.size();
    }
    plain += c;
    text.remove_prefix(length);
  }
  return plain;
}

std::string_view until(std::string_view text, std::string_view end) { return text.substr(0, text.find_first_of(end)); }

}  // namespace

std::string XmlTag::attribute(std::string_view wanted) const {
  const auto found = attributes.find(wanted);
  return found == attributes.end() ? "" : found->second;
}

std::optional<XmlTag> XmlTags::next() {
  const std::size_t begin = rest_.find('<');
  if (begin == std::string_view::npos) return std::nullopt;
  rest_.remove_prefix(begin + 1);
  const std::size_t end = rest_.find('>');
  if (end == std::string_view::npos) return std::nullopt;
  std::string_view content = rest_.substr(0, end);
  rest_.remove_prefix(end + 1);

  XmlTag tag;
  tag.name = until(content.substr(0, 1) == "/" ? content : until(content, "/"), " ");
  for (std::size_t equals = 0; (equals = content.find("=\"")) != std::string_view::npos;) {
    const std::size_t name = content.rfind(' ', equals) + 1;
    const std::size_t value = equals + 2;
    const std::size_t quote = content.find('"', value);
    if (quote == std::string_view::npos) return std::nullopt;
    tag.attributes[std::string(content.substr(name, equals - name))] = unescaped(content.substr(value, quote - value));
    content.remove_prefix(quote + 1);
  }
  return tag;
}

}  // namespace dda
