// Foretells what a scene will be worth before it is run.
#pragma once

#include "engine/advice/advice.h"
#include "engine/simulation/simulation.h"

namespace dda {

Advice advise(const Simulation& simulation, const AdviceQuestion& question);

}  // namespace dda
