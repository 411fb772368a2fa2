// What static steps know of forces that turn with the motion.
//
// Forces act in the geometry of a step's start. As blocks move across a bolt between two anchors it pulls them back by
// N/L, N its tension and L its length; and a force F that stays at a point of a block with the arm r from its centroid
// has a moment that falls by F . r times the turn. In equilibrium the sum of F . r is the block's area times the trace
// of its stress: blocks in tension hang, and turn until their centroids are below what holds them. Weight may have
// nothing else to hold it. A step that knew nothing of this would go past the balance by g dt^2/(2 L), which for a
// short L is more than the way there. Both multiply the motion of the step alone, so that equilibrium is the same with
// them and without; what would push on (compression) is left out.
#pragma once

#include "engine/linear/block_matrix.h"

namespace dda {

struct BlockSystem;

// In static steps of finite kinematics; there is none elsewhere.
[[nodiscard]] bool has_turning_stiffness(const BlockSystem& system);

// Returns whether there is any.
bool add_turning_stiffness(const BlockSystem& system, BlockMatrix& matrix);

// What it takes of the blocks that are not held over system.increment, J per m of thickness: before the states follow.
double turning_work(const BlockSystem& system);

}  // namespace dda
