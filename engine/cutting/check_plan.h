// What a plan must be to be cut.
#pragma once

#include <vector>

#include "engine/cutting/face_groups.h"

namespace dda {

// Boundary, holes and outlines are simple polygons, holes lie inside, lines have finite points. Throws InputError.
void check_plan(const RockPlan& plan);

// Each opening lies in the rock, with a part of its outline at least. Throws InputError.
void check_openings(const Arrangement& arrangement, const std::vector<FacePlace>& places, const PlanPieces& pieces,
                    const RockPlan& plan);

}  // namespace dda
