// The text of a scene whose rock is cut.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "engine/scene/given_blocks.h"

namespace dda {

// One line for each entry of a list, so that the file can be read and compared. In place of the first of some given
// blocks all of them are written, with the rest of its entry.
std::string written_scene(const nlohmann::json& document, const std::vector<GivenBlocks>& given,
                          const std::vector<std::string>& materials);

}  // namespace dda
