// Elasticity of a block with constant stress: strain energy 1/2 area * stress . elasticity^-1 stress. The stress is
// carried from step to step, so in-situ (initial) stress needs no term of its own.
#pragma once

#include "engine/core/types.h"

namespace dda {

inline Mat3 strain_stiffness(double area, const Mat3& elasticity) { return area * elasticity; }

// Internal force on the strains (ex, ey, gxy).
inline Vec3 stress_force(double area, const Vec3& stress) { return area * stress; }

inline double strain_energy(double area, const Vec3& stress, const Mat3& compliance) {
  return area / 2 * stress.dot(compliance * stress);
}

}  // namespace dda
