// What became of the lines of a plan: which of their stretches cut, and what was cleaned from them.
#pragma once

#include <vector>

#include "engine/cutting/face_groups.h"

namespace dda {

// The straight whose joint counts along an edge: what was drawn there before what is only prolonged; joints before
// outlines of openings, those before construction lines, those before the boundary; of several of a kind, the later in
// the plan.
int counting_straight(const Arrangement& arrangement, int edge, const PlanPieces& pieces, const RockPlan& plan);

// Name of the joint along a straight; empty for the default joint.
const std::string& joint_of(const Source& source, const RockPlan& plan);

// Appends to `cleaned`; `groups` as they were before anything was merged.
void report_lines(const Arrangement& arrangement, const FaceGroups& groups, const PlanPieces& pieces,
                  const RockPlan& plan, std::vector<Cleaned>& cleaned);

}  // namespace dda
