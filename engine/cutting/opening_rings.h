// Rings around openings: lines at growing distances from an outline, and cuts across them.
#pragma once

#include <string>
#include <vector>

#include "engine/cutting/rock_plan.h"

namespace dda {

struct OpeningRings {
  int count = 1;
  double thickness = 0;  // m, of the innermost
  double growth = 1;     // thickness of each over that of the one before
  int cuts = 0;          // across each ring, about; 0: so many that the innermost has squares
  std::string joint;
  std::string origin;  // for messages
};

// Lines that only cut. Rings have the corners of the outline, moved outwards on the lines that halve their angles, so
// that edges stay parallel. A cut leaves each corner that turns by more than 30 degrees, and cuts divide the outline
// between these evenly. Throws InputError when a ring would meet itself.
std::vector<PlanLine> rings_around(const Ring& outline, const OpeningRings& rings);

}  // namespace dda
