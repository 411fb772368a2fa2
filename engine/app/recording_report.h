// What `dda check` says of recordings.
#pragma once

#include <string>
#include <vector>

#include "dda/model/model.h"

namespace dda {

// Duration, peak and what is left at the end of every recording, one line each (one for all that use it alike).
std::vector<std::string> describe_recordings(const Model& model);

// A line for every recording whose samples are closer than a stage's steps, so that the stage misses some.
std::vector<std::string> warn_of_recordings(const Model& model, const Stage& stage);

}  // namespace dda
