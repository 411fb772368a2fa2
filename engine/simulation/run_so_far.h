// What can be said of a run between its steps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "engine/simulation/simulation.h"

namespace dda {

// How many stages are over.
std::size_t stages_done(const Simulation& simulation);

// Its linings as they are.
const LiningSet& linings_of(const Simulation& simulation);

// What energy() was at the end of each of them.
std::span<const EnergyLedger> energy_at_ends_of_stages(const Simulation& simulation);

// Between two stages and after the last one: why a run is to end with the stage that is over, which is no equilibrium,
// here or in the columns of a free field; empty where it may go on. A run that ended so and is restored is told once
// more.
std::string unbalanced_end(const Simulation& simulation);

// In all stages but those that pace themselves.
std::int64_t steps_in_all_stages(const Simulation& simulation);

}  // namespace dda
