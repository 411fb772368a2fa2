// Principal values and directions of a stress (xx, yy, xy) in the plane: a point and the radius of Mohr's circle.
#pragma once

#include <cmath>

#include "engine/core/types.h"

namespace dda {

inline double mean_stress(const Vec3& stress) { return (stress(0) + stress(1)) / 2; }

// The largest shear stress on any surface, half the difference of the principal stresses.
inline double largest_shear(const Vec3& stress) { return std::hypot((stress(0) - stress(1)) / 2, stress(2)); }

// The larger principal stress: tension is positive.
inline double largest_principal(const Vec3& stress) { return mean_stress(stress) + largest_shear(stress); }

// The smaller one.
inline double smallest_principal(const Vec3& stress) { return mean_stress(stress) - largest_shear(stress); }

// The size of the principal stress that is the larger by size.
inline double largest_stress(const Vec3& stress) { return std::abs(mean_stress(stress)) + largest_shear(stress); }

// Direction of the larger principal stress, counter-clockwise from x, above -pi/2 up to pi/2.
inline double principal_angle(const Vec3& stress) { return std::atan2(2 * stress(2), stress(0) - stress(1)) / 2; }

}  // namespace dda
