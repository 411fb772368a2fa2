// Steps that were taken in parts since their contacts found no balance: what a run says of them at its end.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "engine/simulation/simulation.h"

namespace dda {

// Null where there were none.
nlohmann::ordered_json unsettled_json(const Simulation& simulation);

// One sentence; empty where there were none.
std::string unsettled_remark(const Simulation& simulation);

}  // namespace dda
