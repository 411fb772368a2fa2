// A scene with what its model does not keep: the groups of its blocks, the openings of its rock, and what became of
// that in cutting.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "engine/cutting/rock_plan.h"
#include "engine/model/model.h"
#include "engine/scene/given_blocks.h"

namespace dda {

struct SceneParts {
  Model model;
  std::vector<std::string> groups;    // of each block
  std::vector<PlanOpening> openings;  // of all rock, in the order of the scene
  std::vector<std::string> remarks;   // on cutting the rock, see cut_remarks.h, and on fields that reach no block
};

// As read_scene and parse_scene.
SceneParts read_scene_parts(const std::filesystem::path& file);
SceneParts parse_scene_parts(std::string_view json_text, const std::string& name_for_errors,
                             const std::filesystem::path& folder = {});

// As parse_scene of the text of a document that is known to follow the schema. `given`: in the order of their entries.
Model read_document(const nlohmann::json& document, const std::vector<GivenBlocks>& given,
                    const std::string& name_for_errors, const std::filesystem::path& folder);

}  // namespace dda
