// What the work on steps cost, in counts that do not depend on the machine; engine/core/phase_clock.h measures times.
#pragma once

#include "engine/core/counters.h"

namespace dda {

struct Costs {
  Counters counters;
};

}  // namespace dda
