// A population of rocks as JSON, as a page and as pictures.
#pragma once

#include <string>
#include <vector>

#include "verification/rocks/rock_run.h"

namespace verify {

[[nodiscard]] std::string to_json(const std::vector<RockResult>& results);

// docs/rocks.md: a table by kind, the gallery, and every rock that is not right with the reason.
[[nodiscard]] std::string to_page(const std::vector<RockResult>& results);

// The rock as drawn beside the rock at its end, held blocks grey and loose ones in colour.
[[nodiscard]] std::string to_svg(const RockPicture& picture);

// The file name of the picture of a kind.
[[nodiscard]] std::string picture_of(RockKind kind);

}  // namespace verify
