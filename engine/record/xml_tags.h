// The tags of a small XML text, one after the other.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace dda {

struct XmlTag {
  std::string name;  // "/NAME" for a closing tag
  std::map<std::string, std::string, std::less<>> attributes;

  // Empty when there is none.
  [[nodiscard]] std::string attribute(std::string_view name) const;
};

class XmlTags {
 public:
  // `text` must outlive the object.
  explicit XmlTags(std::string_view text) : rest_(text) {}

  // Nothing at the end of the text, or at a tag that does not end.
  std::optional<XmlTag> next();

 private:
  std::string_view rest_;
};

}  // namespace dda
