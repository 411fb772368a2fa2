#include "engine/scene/unmerged_scene.h"

#include <nlohmann/json.hpp>

#include "engine/scene/json_text.h"
#include "engine/scene/schema_check.h"

namespace dda {

std::optional<std::string> without_merging(std::string_view json_text) {
  nlohmann::json document = parse_json(json_text);
  check_schema(document);
  std::size_t found = 0;
  const auto strip = [&found](nlohmann::json& entry) {
    if (entry.contains("rock")) found += entry["rock"].erase("merge");
  };
  nlohmann::json& blocks = document["blocks"];
  if (blocks.is_array())
    for (nlohmann::json& entry : blocks) strip(entry);
  else
    strip(blocks);
  return found > 0 ? std::optional(document.dump()) : std::nullopt;
}

}  // namespace dda
