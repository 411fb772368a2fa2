// Contacts counted by what they do at the moment.
#pragma once

#include <cstdint>

#include "engine/simulation/simulation.h"

namespace dda {

struct ContactStatistics {
  // Contact points: the ends of a stretch count by themselves, a vertex once. Bonded ones stick.
  int open = 0, sliding = 0, sticking = 0;
  double penetration = 0;   // m, the deepest that blocks are in each other
  std::int64_t passes = 0;  // of the open-close iteration in the last step, with all its halves
};

ContactStatistics count_contacts(const Simulation& simulation);

}  // namespace dda
