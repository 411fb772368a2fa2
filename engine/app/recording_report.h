// What `dda check` says of recordings.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/model/model.h"

namespace dda {

// Duration, peak and what is left at the end of every recording, one line each (one for all that use it alike).
std::vector<std::string> describe_recordings(const Model& model);

// A line for every recording that runs in this stage and whose samples are closer than its steps: the stage misses
// some.
std::vector<std::string> warn_of_recordings(const Model& model, std::size_t stage);

}  // namespace dda
