// Inertia of a block: kinetic energy 1/2 v M v with the velocities v of the six unknowns.
#pragma once

#include "dda/core/types.h"
#include "dda/geometry/polygon.h"

namespace dda {

// Mean squares of the offsets from the centroid, m^2: (x x), (y y), (x y).
Vec3 mean_squares(const AreaMoments& moments);

// The same after the deformation F of the block, which carries its mass along: F J F^T.
Vec3 deformed_mean_squares(const Vec3& mean_squares, const Mat2& deformation);

// The 6x6 mass matrix of a block of `mass` (kg per m of thickness): the integral of rho T^T T (Shi 1988). The inertia
// of the strains is multiplied by `strain_inertia` (see Stage), which leaves the inertia of rigid motions alone.
Mat6 mass_matrix(double mass, const Vec3& mean_squares, double strain_inertia = 1);

}  // namespace dda
