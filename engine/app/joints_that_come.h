// The joints of blocks that a stage adds, for people: as they are drawn, which those are that come about where their
// neighbours are still near their places.
#pragma once

#include <cstddef>
#include <string>

#include "engine/model/model.h"

namespace dda {

// How many joints of which law come in with the blocks that the stage adds; empty where there are none.
std::string joints_that_come(const Model& model, std::size_t stage);

}  // namespace dda
