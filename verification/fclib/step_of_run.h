// The problem of the next step of a run, in the geometry in which its contacts were looked for last.
#pragma once

#include "verification/fclib/step_conversion.h"

namespace dda {
class Simulation;
}

namespace verify {

// What a GeneralStep would pose, but that it does not foresee where blocks will be (ADR 30) and does not search.
[[nodiscard]] OwnedStep next_step(const dda::Simulation& simulation);

}  // namespace verify
