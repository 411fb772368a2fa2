// What must hold of a rock, whatever rules moved it: outlines, weights and Coulomb's law.
#pragma once

#include <vector>

#include "engine/simulation/simulation.h"
#include "verification/study/judged_run.h"

namespace verify {

// At the end of a static stage.
[[nodiscard]] std::vector<Check> settled_checks(const dda::Simulation& simulation);

// At the end of a stage of motion that took `motion` seconds.
[[nodiscard]] std::vector<Check> moved_checks(const dda::Simulation& simulation, double motion);

}  // namespace verify
