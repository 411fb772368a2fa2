// Everything a simulation keeps from step to step besides its State, as bytes, so that it can go on elsewhere to the
// last bit as if it had not stopped. What follows from model and state alone is left out and made anew.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/model/state.h"
#include "engine/simulation/simulation.h"

namespace dda {

// To be taken between steps.
std::vector<std::byte> save(const Simulation& simulation);

// Brings a simulation of the same model to where `snapshot` and `state` were saved. Its counters go on from there, with
// one more analysis and factorization. Loads and the durations of stages may differ from those of the saved run; throws
// InputError (without a file) when the number of stages, interfaces, supports, loads or viscous edges does, when the
// stage that was under way has another time step or is now over, or when the bytes are not a snapshot.
void restore(Simulation& simulation, State state, std::span<const std::byte> snapshot);

}  // namespace dda
