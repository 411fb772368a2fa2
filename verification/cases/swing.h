// The frequency of a mode of a linear scene, from a run that starts with the velocities of the mode's shape.
#pragma once

#include <functional>

#include "engine/core/types.h"
#include "engine/simulation/simulation.h"

namespace verify {

// rad/s, of the blocks alone: from the `zeros`-th time that the displacements' share of `shape` (m, at a block's
// centroid) passes zero, with the period error of the trapezoidal rule, omega = 2/dt tan(omega' dt/2), taken out. The
// stage must be trapezoidal. Throws std::runtime_error if a step fails or the run ends before.
[[nodiscard]] double swing_frequency(dda::Simulation& simulation,
                                     const std::function<dda::Vec2(const dda::Vec2&)>& shape, int zeros);

}  // namespace verify
