// The part of a run in which blocks move: stages that end at equilibrium take no time.
#pragma once

#include <nlohmann/json.hpp>

#include "engine/view/histories.h"

namespace dda {

// s, when the first stage begins that does not end at equilibrium; 0 where the summary (or null) knows of none.
double first_moment(const nlohmann::ordered_json& summary);

// The rows from `time` (s) on; all of them where that leaves less than two.
Histories from(double time, Histories histories);

}  // namespace dda
