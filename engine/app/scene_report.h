// What `dda check` prints.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/model/model.h"

namespace dda {

// What will be run, for people: blocks, contacts, stages with their terms, phases and solver, sizes, and predicted
// errors of waves of `frequency` (Hz; without one, of the highest sine in the scene); `remarks` were made in reading
// the scene. Throws InputError (without a file) for what only setting up a run finds out, e.g. a traction measured
// where blocks do not touch.
std::string describe_scene(const Model& model, std::optional<double> frequency = std::nullopt,
                           const std::vector<std::string>& remarks = {});

}  // namespace dda
