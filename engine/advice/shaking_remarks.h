// Motions of the ground that shake what stands on it otherwise than meant: by displacements that jump or have kinks,
// and beside damping that holds on to the ground as it was.
#pragma once

#include <string>
#include <vector>

#include "engine/model/model.h"

namespace dda {

// A sentence each, without a full stop; one for all blocks that are moved alike. For stages that run in time:
//   displacements that are not zero at 0 s, or where a record begins or ends: the block goes there in a step;
//   displacements of records whose samples are further apart than steps: straight lines, whose velocity jumps at each;
//   damping in proportion to inertia, which brakes absolute velocities, beside ground that moves.
std::vector<std::string> shaking_remarks(const Model& model);

}  // namespace dda
