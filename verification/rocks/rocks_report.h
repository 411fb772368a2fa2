// A population of rocks as JSON, as a page and as pictures.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "verification/rocks/rock_run.h"

namespace verify {

// One of them, and back from there.
[[nodiscard]] nlohmann::ordered_json json_of(const RockResult& result);
[[nodiscard]] RockResult rock_result_from(const nlohmann::ordered_json& json);

[[nodiscard]] std::string to_json(const std::vector<RockResult>& results);

// docs/rocks.md: a table by kind, the gallery, and every rock that is not right with the reason.
[[nodiscard]] std::string to_page(const std::vector<RockResult>& results);

// The rock as drawn beside the rock at its end, held blocks grey and loose ones in colour.
[[nodiscard]] std::string to_svg(const RockPicture& picture);

// The file name of the picture of a kind.
[[nodiscard]] std::string picture_of(RockKind kind);

}  // namespace verify
