// A plan as straight pieces ready for noding, each with where it comes from.
#pragma once

#include <string>
#include <vector>

#include "engine/cutting/noding.h"
#include "engine/cutting/rock_plan.h"

namespace dda {

// Closed curves that say what belongs to what: the boundary, then holes, then openings.
inline constexpr int boundary_curve = 0;
inline constexpr int no_curve = -1;
inline constexpr int no_line = -1;

struct Source {
  int curve = no_curve;
  int line = no_line;  // of the plan
};

struct PlanPieces {
  PixelGrid grid;
  double tolerance = 0;  // m
  std::vector<Straight> straights;
  std::vector<Source> sources;  // by straight
  std::vector<Piece> pieces;
  std::vector<KnownNode> ends;   // as drawn, by pixel
  std::vector<bool> prolonged;   // by straight: whether it is prolonged at an end or both
  std::vector<bool> ends_alone;  // by straight: whether it is not prolonged at its end, as nothing is near
  std::vector<Cleaned> cleaned;
};

inline int curve_of_hole(std::size_t hole) { return 1 + static_cast<int>(hole); }
inline int curve_of_opening(const RockPlan& plan, std::size_t opening) {
  return 1 + static_cast<int>(plan.holes.size() + opening);
}

// True where the straight is a part of the boundary or of a hole.
inline bool is_bound(const PlanPieces& pieces, int straight, const RockPlan& plan) {
  const int curve = pieces.sources[static_cast<std::size_t>(straight)].curve;
  return curve != no_curve && curve < curve_of_opening(plan, 0);
}

// Lines are cut off well outside the boundary, and prolonged by the tolerance at both of their ends: a line that should
// end on another meets it whatever the round-off, and what then sticks out is trimmed with the other dangling ends.
// Ends that have nothing near them are not prolonged (lonely_ends.h): most of those of short lines by lot.
PlanPieces pieces_of(const RockPlan& plan, double tolerance);

// At which of `nodes`, pixels that ascend, something that was drawn ends.
std::vector<bool> drawn_nodes(const std::vector<Pixel>& nodes, const PlanPieces& pieces);

}  // namespace dda
