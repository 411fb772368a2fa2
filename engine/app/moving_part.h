// The part of a run in which blocks move: stages that end at equilibrium take no time.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "engine/view/histories.h"

namespace dda {

// s, when the first stage begins that does not end at equilibrium; before all times where the summary (or null) knows
// of none.
double first_moment(const nlohmann::ordered_json& summary);

// The rows from the last one at `time` (s) on, as those before it at that time are what static stages began with; all
// of them where that leaves less than two.
Histories from(double time, Histories histories);

// A displacement without what static stages that take no time have moved it by, which two rows of the same time show.
std::vector<double> without_jumps(const std::vector<double>& times, std::vector<double> values);

}  // namespace dda
