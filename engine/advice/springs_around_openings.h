// Walls that are laid free in rock whose closed joints are springs.
//
// Springs at both ends of a closed joint tie the ends of its blocks' faces to each other. A block has one strain, so
// two blocks that are tied along a face have the same strain along it, and what is tied along faces of two directions
// has nearly no strain of its own: where strain changes from block to block, as around an opening, the blocks are
// locked, the more the stiffer the springs. The compliance that dda check says of springs is that of uniform stress,
// where nothing locks. A round hole of 1 m in rings of 9 x 24 blocks to 10 m, under the same pressure from all sides,
// comes in by 0.53 of Lame's solution with springs of 10 E, by 0.16 with chosen ones, by 0.99 with projected joints; 18
// x 48 blocks: 0.82, 0.45 and 1.00. Springs of the joint's own that give way as much as the blocks beside them lock
// little: 0.92 and 0.99 of what projected joints of the same stiffness give, where they add 70 % to the compliance of
// the blocks.
#pragma once

#include <string>
#include <vector>

#include "engine/model/model.h"

namespace dda {

// A sentence, without a full stop, where a stage takes blocks out, or faces are free under the initial stress, and
// blocks that stay are tied by stiff springs along faces of two directions; else none.
std::vector<std::string> springs_around_openings(const Model& model);

}  // namespace dda
