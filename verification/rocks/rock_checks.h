// What must hold of a rock, whatever rules moved it: outlines, weights and Coulomb's law.
#pragma once

#include <vector>

#include "engine/simulation/simulation.h"
#include "verification/rocks/rock_run.h"

namespace verify {

// Where the corners of every block are.
[[nodiscard]] std::vector<dda::Polygon> outlines_now(const dda::Model& model, const dda::State& state);

// At the end of a static stage.
[[nodiscard]] std::vector<RockCheck> settled_checks(const dda::Simulation& simulation);

// At the end of a stage of motion that took `motion` seconds.
[[nodiscard]] std::vector<RockCheck> moved_checks(const dda::Simulation& simulation, double motion);

}  // namespace verify
