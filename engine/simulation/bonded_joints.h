// Bonded interfaces in a step of a scene that is not linear: they are part of its constant matrix.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "engine/core/types.h"
#include "engine/simulation/block_system.h"

namespace dda {

// Returns the force of interface `i` at the end of a step by `increment`, its gap being `gap`; the state has not moved.
Vec4 bonded_force(const BlockSystem& system, const Eigen::VectorXd& increment, std::size_t i, const Vec4& gap);

// Which ends of interface `i` are beyond their strength there. In a stage of unlimited strength dry ones that are
// pulled.
std::array<bool, 2> ends_that_break(const BlockSystem& system, const Eigen::VectorXd& increment, std::size_t i);

// Gaps and forces of the interfaces at these places follow system.increment, before the blocks' stresses do.
void accept_bonded(const std::vector<int>& bonded, BlockSystem& system);

}  // namespace dda
