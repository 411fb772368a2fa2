// What the work on steps cost: counts that do not depend on the machine, and wall times that do.
#pragma once

#include "engine/core/counters.h"
#include "engine/core/phase_times.h"

namespace dda {

struct Costs {
  Counters counters;
  PhaseTimes times;
};

}  // namespace dda
