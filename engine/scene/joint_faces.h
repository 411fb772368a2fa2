// Both faces of joints, on which water in them acts.
#pragma once

#include <vector>

#include "engine/builder/ground_plan.h"
#include "engine/model/model.h"
#include "engine/model/stage_span.h"
#include "engine/scene/field.h"

namespace dda {

// A face of a block, and the stages in which something acts on it.
struct PressedFace : Stretch {
  StageSpan stages;
};

// `edge`: "joints", or an object with the names of some. Faces are of blocks that touch as drawn, always two, in those
// of `stages` in which both of their blocks are there; at least one pair. None of bonded joints, which water cannot
// open.
std::vector<PressedFace> faces_of_joints(const Field& edge, const StageSpan& stages, const Model& model);

}  // namespace dda
