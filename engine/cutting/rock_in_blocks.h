// What cutting a plan of rock is asked for, and what comes of it.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/cutting/cleaned.h"
#include "engine/geometry/polygon.h"

namespace dda {

struct CutOptions {
  double tolerance = 0;    // m; 0: 1e-6 of the diameter of the boundary
  double least_area = 0;   // m2: smaller blocks are merged into a neighbour
  double least_angle = 0;  // rad: so are blocks with a sharper corner
  std::size_t most_blocks = 2'000'000;
  int most_rounds = 20;  // of closing round-off; when they are used up, a remark says so
  // Called with what is being done, before each part of the work.
  std::function<void(std::string_view)> progress;
};

struct CutBlock {
  Polygon shape;     // outer ring counter-clockwise, from its leftmost vertex on; neighbours share their corners' bits
  int opening = -1;  // of the plan, which will take it out; -1: none
  std::string material;  // as the plan names it; empty: that of all blocks
  std::string group;     // of a block that was given as it is; empty: that of its opening, else of all blocks
};

// A straight run along which blocks touch.
struct CutJoint {
  Vec2 from, to;
  std::string joint;  // as the plan names it; empty: the default joint
};

// What a fill came to.
struct CutFill {
  std::string origin;
  std::size_t blocks = 0;  // between joints, that were filled
  std::size_t sites = 0;   // of cells
  std::size_t short_edges_closed = 0;
};

struct CutRock {
  std::vector<CutBlock> blocks;  // from left to right
  std::vector<CutJoint> joints;
  std::vector<Cleaned> cleaned;
  std::vector<CutFill> fills;
  std::vector<std::string> remarks;  // sentences on what was not done as it should be, though all areas are right
  double tolerance = 0;              // m, that was used
  double boundary_area = 0;          // m2: boundary less holes, from the plan
  double left_out_area = 0;          // m2, of it in openings that are left out
  double dropped_area = 0;           // m2, of it in slivers without neighbour; blocks are the rest
  int merged = 0;                    // blocks that went to a neighbour
  int dangles_trimmed = 0;
  std::size_t outlines_traced = 0;  // of blocks, before any were merged and after
  std::size_t pieces_noded = 0;     // straight pieces that were compared with others to find where they meet
  std::size_t pairs_looked_at = 0;  // of these with each other and with nodes, the dearest part of cutting
};

}  // namespace dda
