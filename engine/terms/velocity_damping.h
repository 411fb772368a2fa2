// Damping that scales velocities at the end of a step.
#pragma once

#include <cmath>

namespace dda {

// `per_step` is Shi's dynamic parameter k01, whose effect depends on dt; `rate` (1/s) does not: exp(-rate dt).
inline double velocity_factor(double per_step, double rate, double dt) { return per_step * std::exp(-rate * dt); }

}  // namespace dda
