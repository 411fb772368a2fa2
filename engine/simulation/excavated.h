// What excavation leaves in a system: which blocks are absent, and what they exerted on the others.
#pragma once

#include <vector>

#include "engine/simulation/released_forces.h"

namespace dda {

struct Excavated {
  std::vector<bool> absent;  // of every block whether it is not there now; empty while all are
  ReleasedForces released;

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [absent, released] = self;
    archive(released);  // what is absent follows from the stage
  }
};

}  // namespace dda
