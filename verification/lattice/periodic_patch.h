// A piece of a periodic mesh as a model.
#pragma once

#include "engine/model/model.h"
#include "verification/lattice/periodic_mesh.h"

namespace verify {

// The middle cell with `around` cells on every side of it, bonded, in a stage of small kinematics; finished. Cells are
// in the order of `translation`, so those of a patch with `around` 1 have its numbers.
[[nodiscard]] dda::Model periodic_patch(const PeriodicMesh& mesh, int around, const dda::Material& rock,
                                        const dda::JointMaterial& bond);

}  // namespace verify
