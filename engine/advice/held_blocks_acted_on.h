// Loads and supports on blocks that are held as a whole: nothing of them reaches the rock.
#pragma once

#include <string>
#include <vector>

#include "engine/model/model.h"

namespace dda {

// A sentence for every load and one for the supports of which blocks that are held take some, without a full stop. Edge
// loads that follow one another with the same pressure and history count as one load.
std::vector<std::string> acting_on_held_blocks(const Model& model);

}  // namespace dda
