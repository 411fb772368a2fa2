// What a run's ledger of energies says of its result: it can go through to the end and still be wrong.
#pragma once

#include <string>

#include "engine/core/status.h"
#include "engine/simulation/simulation.h"

namespace dda {

struct EnergyVerdict {
  Status status = Status::ok;  // or gained_energy, inaccurate
  std::string message;         // why, or a warning; empty when there is nothing to say
};

EnergyVerdict judge_energy(const Simulation& simulation);

}  // namespace dda
