// Ends of rows of blocks that are one block wide, where supports clamp them.
#pragma once

#include <optional>

#include "engine/builder/ground_plan.h"
#include "engine/model/model.h"

namespace dda {

// How the half of a block beside a held stretch of its outline bends, N m per rad and m of thickness: E I/d, d the
// distance of its centroid. Only of a block that ends a row there: held all across, with one neighbour all along the
// opposite side and none elsewhere. The block itself has one strain and cannot bend. There is nothing in a mesh, where
// no block is beyond, and of ground on which a smaller block stands.
std::optional<double> bending_of_row_end(const Stretch& held, const GroundPlan& plan, const Model& model);

}  // namespace dda
