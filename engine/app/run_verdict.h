// What a run that went through to its end says of its own result: it can do so and still be wrong.
#pragma once

#include <string>

#include "engine/core/status.h"
#include "engine/simulation/simulation.h"

namespace dda {

struct RunVerdict {
  Status status = Status::ok;  // or gained_energy, inaccurate
  std::string message;         // why, or a warning; empty when there is nothing to say
};

// By its ledger of energies, by how deep blocks are in each other at its end, and by how far they have gone in small
// kinematics.
RunVerdict judge_run(const Simulation& simulation);

// By these alone.
RunVerdict judge_energy(const Simulation& simulation);
RunVerdict judge_motion(const Simulation& simulation);
RunVerdict judge_penetration(const Simulation& simulation);

}  // namespace dda
