// A plan of rock: what is drawn before anything is cut. Scenes and readers of drawings fill it, cut_rock cuts it into
// blocks. Plain data; lengths in m, x right, y up. Nothing here has to be clean: lines may cross, touch, run along each
// other, stick out of the boundary or end inside the rock, and rings may turn either way.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/cutting/cleaned.h"
#include "engine/geometry/polygon.h"

namespace dda {

// A joint or any other line that cuts, straight or with corners.
struct PlanLine {
  std::vector<Vec2> points;  // two or more, from end to end; a closed one repeats its first point at the end
  std::string joint;         // name of the joint along it; empty: the default joint
  std::string origin;        // where it was given, for messages: "lines[3]", "plan.dxf line 214 (layer rock)"
  // Cuts only, as the lines of a mesh inside intact rock do: where another line runs along it, that one's joint counts.
  bool construction = false;
};

// A named part of the rock that is, or can be, taken out: a tunnel, a shaft, a removable hole.
struct PlanOpening {
  std::string name;  // of the group of its blocks
  Ring outline;
  std::string joint;      // along its outline; empty: the default joint
  bool left_out = false;  // true: no blocks inside; false: cut like the rest, as a group to be excavated
  std::string origin;
};

// Blocks whose inside lies in the outline have this material. Where regions overlap, the later one counts.
struct PlanRegion {
  Ring outline;
  std::string material;
  std::string origin;
};

// Cells, the polygons of a Voronoi diagram, that fill blocks between joints.
struct PlanFill {
  double size = 0;            // m, the side of a square as large as a cell
  std::vector<Ring> fine_at;  // outlines at which cells have the size `finest`, growing by `growth` per m from there
  double finest = 0;          // m
  double growth = 0;
  int relax = 0;          // how often sites move to the centroids of their cells
  double short_edge = 0;  // of the size of a cell: shorter edges are closed
  Ring region;            // blocks inside are filled, and it cuts; empty: all blocks
  std::uint64_t seed = 1;
  std::string joint;  // along the walls of cells, which only cut
  std::string origin;
};

// A block that is given as it is, not cut.
struct PlanBlock {
  Polygon shape;         // rings may turn either way
  std::string group;     // its blocks are numbered together, and can be taken out together
  std::string material;  // empty: that of the plan
  std::string origin;
};

// A place that a drawing marks: a fixed point, a load point, a measuring point, a hole point, a blast.
struct PlanPoint {
  Vec2 at = Vec2::Zero();
  std::string layer;  // what it marks: "measure point"
  std::string name;
  std::string origin;
};

// Lines that a drawing marks without cutting along them: absorbing boundaries and the like.
struct PlanMark {
  std::vector<Vec2> points;
  std::string layer;
  std::string origin;
};

// Either rock to cut, with a boundary, or blocks. With blocks there are no boundary, holes, openings and fills, and
// lines say which joints are along edges of blocks.
struct RockPlan {
  Ring boundary;  // the first vertex is not repeated
  std::vector<Ring> holes;
  std::string boundary_origin;  // for messages: "boundary", "plan.dxf (layer boundary)"
  std::string material;         // of blocks in no region; empty: the only one
  std::vector<PlanLine> lines;
  std::vector<PlanOpening> openings;
  std::vector<PlanRegion> regions;
  std::vector<PlanFill> fills;
  std::vector<PlanBlock> blocks;
  std::vector<PlanPoint> points;
  std::vector<PlanMark> marks;
  std::vector<Cleaned> cleaned;  // when the plan was read, before anything is cut
};

}  // namespace dda
