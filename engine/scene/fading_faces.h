// Faces on which removed blocks go on acting for a while: those across which they lay when a stage took them out with a
// force that fades.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/builder/ground_plan.h"
#include "engine/model/model.h"

namespace dda {

struct FadingFace {
  Stretch face;           // of a block that stays
  StageSpan stages;       // in which something of the force is left, from the one that removes the blocks on
  std::size_t stage = 0;  // that removes them
};

// `plan`: of all blocks of the model, whose stages are complete.
std::vector<FadingFace> fading_faces(const GroundPlan& plan, const Model& model);

}  // namespace dda
