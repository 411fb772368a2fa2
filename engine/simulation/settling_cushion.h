// What keeps a step of a static stage from opening and closing more contacts than its iteration can follow.
//
// A static step solves (c_m M + K) d = forces out of balance. Shorter steps hold back motions of much mass and little
// stiffness alone; what hops in rock of many small, wedged blocks is the stiffest there is, ends that open in one pass
// and are driven deep into each other in the next, and these the mass does not hold back before steps are so short that
// nothing moves any more. Cushions do: an end that touches as the step begins resists the change of its normal gap,
// both ways, by a share of its normal stiffness beside what its spring answers,
//   force = cushion * k_n * change of the normal gap in the step.
// As they multiply the motion of the step alone, cushions are nothing once the motion has died down: equilibrium is the
// same with them and without. Slip is free: blocks that slide to where they come to lie would take many steps else.
#pragma once

#include <span>

#include "engine/linear/block_matrix.h"

namespace dda {

struct BlockSystem;

// Adds the cushions of `system.cushion` to the matrix of a step that is about to be solved. `contacts`: places of those
// that can open.
void add_cushions(const BlockSystem& system, std::span<const int> contacts, BlockMatrix& matrix);

// What they take of the blocks that are not held over the increments solved for, J per m of thickness: before the
// states of the contacts follow.
double work_of_cushions(const BlockSystem& system, std::span<const int> contacts);

}  // namespace dda
