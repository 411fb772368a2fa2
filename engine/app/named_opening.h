// Openings as options of the command line name them.
#pragma once

#include <string>
#include <vector>

#include "engine/scene/scene_parts.h"

namespace dda {

// Throws InputError: nothing has the name; says what is there, and what may have been meant.
[[noreturn]] void refuse_opening(const std::string& name, const SceneParts& scene);

// The blocks inside of an opening, or of a group, ascending. Throws InputError where there are none.
[[nodiscard]] std::vector<int> blocks_of_opening(const std::string& name, const SceneParts& scene);

// Throws InputError where these blocks of that name, taken out of the rock by the stage that removes them (or from the
// rock as the first stage has it), leave it open in several places: each has a wall of its own.
void expect_one_opening(const std::string& name, const std::vector<int>& blocks, const Model& model);

}  // namespace dda
