// Outlines of groups of faces: walks along the edges between groups.
#pragma once

#include <vector>

#include "engine/cutting/face_groups.h"

namespace dda {

struct Outline {
  int group = 0;
  std::vector<int> outer;               // half-edges, the block on their left
  std::vector<std::vector<int>> holes;  // around what lies inside the block
};

// Returns the outlines of all groups but that outside, in the order of the first of their half-edges.
std::vector<Outline> trace_outlines(const Arrangement& arrangement, const FaceGroups& groups);

// Returns the same for some groups at a time, after these have changed.
class OutlineTracer {
 public:
  OutlineTracer(const Arrangement& arrangement, const FaceGroups& groups);

  // `half_edges`, ascending, are all that border the groups asked for; others among them are passed over.
  std::vector<Outline> trace(const std::vector<int>& half_edges);

 private:
  void trace_from(int start, std::vector<Outline>& outlines);

  const Arrangement& arrangement_;
  const FaceGroups& groups_;
  std::vector<int> outline_of_;  // by group
  std::vector<bool> seen_;       // by half-edge
};

// Where the outline of a block touches itself in a point, as around a block that hangs with one corner at a joint, the
// blocks in the loop get a corner of their own, `distance` (m) inside the loop or less. Appends what was done to
// `cleaned` and returns whether there was anything.
bool part_touching(Arrangement& arrangement, const std::vector<Outline>& outlines, const PixelGrid& grid,
                   double distance, std::vector<Cleaned>& cleaned);

}  // namespace dda
