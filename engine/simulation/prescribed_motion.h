// Supports, dashpots, free-field sides and held blocks of a block system: their part in a step, and where stages end
// and begin.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "engine/simulation/block_system.h"

namespace dda {

// Adds to the right-hand side of the step what dashpots and the motion of supports make of the state.
void add_dashpot_and_support_rhs(const BlockSystem& system, Eigen::VectorXd& rhs);

// Takes the supports to the end of the step that the state has made.
void accept_supports(BlockSystem& system);

// Supports that end with this stage leave their force behind, so that what they held stays at rest, or take it along.
void let_go_of_supports(BlockSystem& system);
// The same of one of them, whatever its stage.
void let_go_of_support(std::size_t index, BlockSystem& system);

// Dashpots that begin to act with this stage.
void begin_viscous_edges(BlockSystem& system);

// Sums up the internal forces that the step begins with where gaps have been measured anew. What blocks that turn miss
// of a gap in a step, by rows of one moment of it, is put right there, and the forces on held blocks jump.
void measure_internal_forces(BlockSystem& system);

// What moves the held blocks works against all other forces on them, without such jumps: what stiff contacts make of a
// gap of second order in a turn is no force that anything has moved against.
void audit_held_blocks(BlockSystem& system);

// True when loads, supports and held blocks are at `time` what they are now; writes the loads there to forces.load_new.
bool nothing_prescribed_changes_until(double time, BlockSystem& system);

}  // namespace dda
