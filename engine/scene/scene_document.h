// The document of a scene: what the text says, with the shape that the schema asks for.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/scene/plain_lines.h"

namespace dda {

struct SceneDocument {
  nlohmann::json document;
  std::vector<PlainLines> lines;  // of rocks of which the document has the first line only
};

// Throws InputError (without a file) for text that is no JSON and for a document against the schema. Of large texts
// with many lines of rock, all plain, the document does not have these.
SceneDocument read_scene_document(std::string_view text);

// The same of a text of any size, but nothing where lines of rock are not all plain or something is wrong.
std::optional<SceneDocument> document_without_lines(std::string_view text);

}  // namespace dda
