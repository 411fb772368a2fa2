// Rows and grids of equal rectangular blocks and rings around an opening, for scenes and for programs that build a
// Model themselves.
#pragma once

#include <string>
#include <vector>

#include "engine/model/model.h"

namespace dda {

// What all blocks of a generator share. The group name is the start of their names.
struct BlockGroup {
  std::string name;
  int material = 0;
  Vec3 initial_stress = Vec3::Zero();    // Pa, tension positive
  Vec2 initial_velocity = Vec2::Zero();  // m/s
  double initial_spin = 0;               // rad/s
};

// A bar along x, its lower left corner at `origin`. Lengths in m.
struct BarSpec {
  Vec2 origin = Vec2::Zero();
  double length = 0;
  double height = 0;
  double block_length = 0;
  BlockGroup group = {.name = "bar"};
};

enum class GridPattern {
  stack,         // vertical joints in line
  running_bond,  // every second row half a block aside, with half blocks at both its ends
};

// Rows of blocks from below, each from left to right; the lower left corner at `origin`. Lengths in m.
struct GridSpec {
  Vec2 origin = Vec2::Zero();
  int columns = 0;
  int rows = 0;
  double block_width = 0;
  double block_height = 0;
  GridPattern pattern = GridPattern::stack;
  BlockGroup group = {.name = "grid"};
};

// Rings of blocks around an opening, cut by straight radial joints: regular polygons one around the other. Lengths in
// m.
struct RingsSpec {
  Vec2 centre = Vec2::Zero();
  std::vector<double> radii;  // of corners, increasing; the first are those of the opening
  int sectors = 0;            // blocks in a ring
  double first_corner = 0;    // rad, direction of the first radial joint
  BlockGroup group = {.name = "rings"};
};

inline constexpr int most_generated_blocks = 2'000'000;

// Appends the blocks "NAME 1", "NAME 2", ... from left to right and returns the index of the first. Neighbours share
// their corners to the last bit. Throws InputError naming the field of `spec` when a size is not positive or `length`
// is not a whole number (to 1e-6) of blocks.
int append_bar(Model& model, const BarSpec& spec);

// Appends the blocks "NAME ROW.COLUMN", counted from 1.1 below left, and returns the index of the first. Throws
// InputError naming the field of `spec` when a size or count is not positive.
int append_grid(Model& model, const GridSpec& spec);

// Appends the blocks "NAME RING.SECTOR", counted from 1.1, rings outwards and sectors counter-clockwise from
// `first_corner`, and returns the index of the first. Throws InputError naming the field of `spec` when there are fewer
// than two radii or three sectors, or radii do not increase from above 0.
int append_rings(Model& model, const RingsSpec& spec);

}  // namespace dda
