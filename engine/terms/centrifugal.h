// Centrifugal force: a block that turns with the angular velocity `spin` (rad/s) is pulled outwards by
// rho spin^2 (x, y) at the offset (x, y) from its centroid, which does the work mass spin^2 (xx ex + yy ey + xy gxy) on
// its strains. A square of side L then carries the stress rho spin^2 L^2/12.
#pragma once

#include "engine/core/types.h"

namespace dda {

// Force on the strains (ex, ey, gxy). `squares`: mean squares (x x), (y y), (x y) of the offsets, m^2.
inline Vec3 centrifugal_force(double mass, const Vec3& squares, double spin) { return mass * spin * spin * squares; }

}  // namespace dda
