// What linings carry, for frames and for the summary of a run.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "engine/record/lining_frame_writer.h"
#include "engine/simulation/simulation.h"

namespace dda {

// Returns what every element carries, lining after lining.
std::vector<LiningValues> lining_values_of(const Simulation& simulation);

// The entry "linings" of the summary: of each lining the largest of its forces, where they are, and what has yielded.
nlohmann::ordered_json linings_json(const Simulation& simulation);

}  // namespace dda
