// Scene files: JSON to Model. The format is docs/scene.md; its schema is scene_schema.h.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "engine/model/model.h"

namespace dda {

// Reads and checks a scene; the model has gone through finish_model. Throws InputError with one sentence naming the
// file, the field as a JSON path (loads[0].history.sine.frequency), its value and what was expected.
Model read_scene(const std::filesystem::path& file);

// The same from text; `name_for_errors` takes the place of the file's name. Records are looked for relative to
// `folder`.
Model parse_scene(std::string_view json_text, const std::string& name_for_errors,
                  const std::filesystem::path& folder = {});

// The text of a scene file. InputError for one that is missing, no regular file, larger than
// any scene, or a drawing, a frame or the like: then it says which command reads that.
std::string scene_text(const std::filesystem::path& file);

}  // namespace dda
