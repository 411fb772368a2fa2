// What blocks do, as measurements read it: a point of one block, or the mean of several.
#pragma once

#include "engine/model/measurement.h"
#include "engine/simulation/block_system.h"

namespace dda {

// Reads one block at the measurement's point, or the mean of several: stresses by area and principal stresses from that
// mean, displacements, velocities, accelerations and rotations by mass; energies are added up.
double block_value(const BlockSystem& system, const Measurement& measurement);

}  // namespace dda
