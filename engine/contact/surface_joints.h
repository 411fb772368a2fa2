// Which joint lies where two blocks touch: that of a joint line, else that of the pair of blocks.
//
// Lines belong to the drawing. What stays where it was found has the joint of the line it lies on: a stretch, or a lone
// vertex on an edge along which the line runs there. Blocks that move take with them the parts of their edges that were
// drawn along a line: a contact has the joint of the surface that has one, whichever of the two; where two such
// surfaces with different joints meet, it has that of the pair of blocks, as if there were no lines. A bonded line says
// that the two surfaces along it are one rock, and nothing of what else they meet: there they count as surfaces without
// a line.
#pragma once

#include <vector>

#include "engine/contact/outlines.h"
#include "engine/contact/vertex_contact.h"
#include "engine/geometry/box_pairs.h"
#include "engine/geometry/segment.h"
#include "engine/model/model.h"

namespace dda {

// The joint lines of a model, found by where they are: rock of cells has a line for each of its faces, and looking at
// all of them for each face took 40 s for 20,000 cells.
class JointLines {
 public:
  // `model` outlives it.
  explicit JointLines(const Model& model);

  // Index of the joint of a drawn stretch along which two blocks touch. A line must run along more than half of it.
  [[nodiscard]] int joint_of_stretch(int block_a, int block_b, const Segment& stretch) const;

  // The same of a point in which a corner of one block touches an edge of the other. A line must run along the edge
  // there: one that only ends at it lies between other blocks, and where that one is bonded it would glue the corner.
  [[nodiscard]] int joint_of_point(int block_a, int block_b, const Vec2& point, const Segment& edge) const;

  // Indices of the lines whose boxes come near a stretch, in ascending order: all that run along it, and some others.
  [[nodiscard]] std::vector<int> near(const Segment& stretch) const;

 private:
  // That of the latest line beside `place` of which `lies_there` says so, else that of the pair.
  template <typename LiesThere>
  [[nodiscard]] int joint_at(int block_a, int block_b, const Segment& place, const LiesThere& lies_there) const;

  const Model& model_;
  double tolerance_;  // m
  BoxIndex boxes_;
};

class SurfaceJoints {
 public:
  // `outlines` of the blocks as drawn.
  SurfaceJoints(const Model& model, const Outlines& outlines);

  // Index of the joint of a contact where it is now.
  [[nodiscard]] int joint_of(const Model& model, const Outlines& outlines, const VertexContact& contact) const;

 private:
  struct Part {
    int edge = 0;             // number of its first vertex in Outlines
    double from = 0, to = 1;  // shares of its length
    int joint = 0;
  };

  [[nodiscard]] int joint_at(int edge, double place) const;  // -1: none

  std::vector<Part> parts_;  // by edge; of one edge in the order of lines
};

}  // namespace dda
