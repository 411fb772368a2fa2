// Along which lines blocks touch, from corner to corner of blocks, and which joint lies there.
#pragma once

#include <string>
#include <vector>

#include "engine/cutting/corner_places.h"
#include "engine/cutting/corners.h"
#include "engine/cutting/rock_in_blocks.h"
#include "engine/cutting/trace.h"

namespace dda {

// An edge that two blocks share, between two corners that follow each other on the outlines of both.
struct BorderEdge {
  int straight = 0;  // that runs along all of it
  double way = 0;    // of its start along the straight
  int from = 0, to = 0;
  const std::string* joint = nullptr;  // as the plan names it
};

// By straight, and along it.
std::vector<BorderEdge> border_edges(const Arrangement& arrangement, const FaceGroups& groups,
                                     const std::vector<Outline>& outlines, const Corners& corners,
                                     const PlanPieces& pieces, const RockPlan& plan);

// Appends to the joints of `rock`. Edges that follow each other on a straight make one run, unless a node of theirs is
// not quite on it any more: a run from a node that moved aside to one far away would pass those between.
void fill_joints(const std::vector<BorderEdge>& edges, const CornerPlaces& places, const PlanPieces& pieces,
                 const RockPlan& plan, CutRock& rock);

}  // namespace dda
